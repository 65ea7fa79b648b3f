#pragma once

#include <Python.h>

/// Python's lock, for threads that make steps: also for those that still do when the interpreter ends (daemon threads).
/// From then on the interpreter ends every thread that asks for its lock, by unwinding it, which the destructors
/// between here and Python do not allow (the program would be aborted). Such a thread waits for the end of the process
/// instead.
namespace pinball::python {

/// To be called once: at the end of the interpreter waits until no thread is within a step, and keeps all from going
/// on.
void watch_end_of_interpreter();

/// Waits for the end of the process.
[[noreturn]] void wait_for_end();

/// Gives the lock back; what follows belongs to it.
PyThreadState* give_lock();
/// Takes it again, or waits for the end of the process.
void take_lock(PyThreadState* state);

/// Calls work() without the lock.
template <class Work>
void without_lock(const Work& work) {
  PyThreadState* const state = give_lock();
  try {
    work();
  } catch (...) {
    take_lock(state);
    throw;
  }
  take_lock(state);
}

/// The lock for a while, within work that is done without it. A thread that cannot have it any more waits for the end
/// of the process.
class TakenLock {
 public:
  TakenLock();
  ~TakenLock();
  TakenLock(const TakenLock&) = delete;
  TakenLock& operator=(const TakenLock&) = delete;

 private:
  PyGILState_STATE state_;
};

/// What function(argument) returns, a new reference, or null with an error set.
PyObject* call_python(PyObject* function, PyObject* argument);

}  // namespace pinball::python
