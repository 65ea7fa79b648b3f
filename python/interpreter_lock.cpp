#include "interpreter_lock.hpp"

#include <cxxabi.h>
#include <pthread.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace pinball::python {

namespace {

namespace py = pybind11;

std::atomic<bool> ends = false;
std::atomic<int> at_work = 0;  ///< threads that neither have the lock nor wait for it
std::thread::id ending;        ///< the thread that ends the interpreter, where one does

/// A step, and the longest that the end of the interpreter is put off for one.
constexpr std::chrono::seconds longest_wait(10);

bool is_over() { return ends && std::this_thread::get_id() != ending; }

void end_interpreter() {
  ending = std::this_thread::get_id();
  ends = true;
  const py::gil_scoped_release unlocked;  // for those that are in a callback
  const auto begin = std::chrono::steady_clock::now();
  while (at_work > 0 && std::chrono::steady_clock::now() - begin < longest_wait) ::usleep(1000);
}

/// Only the thread that forks lives on there.
void begin_in_child() { at_work = 0; }

}  // namespace

void watch_end_of_interpreter() {
  py::module_::import("atexit").attr("register")(py::cpp_function(end_interpreter));
  ::pthread_atfork(nullptr, nullptr, begin_in_child);
}

void wait_for_end() {
  for (;;) ::pause();
}

PyThreadState* give_lock() {
  ++at_work;
  return PyEval_SaveThread();
}

void take_lock(PyThreadState* state) {
  --at_work;
  if (is_over()) wait_for_end();
  try {
    PyEval_RestoreThread(state);
  } catch (abi::__forced_unwind&) {
    wait_for_end();
  }
}

TakenLock::TakenLock() {
  --at_work;
  if (is_over()) wait_for_end();
  try {
    state_ = PyGILState_Ensure();
  } catch (abi::__forced_unwind&) {
    wait_for_end();
  }
}

TakenLock::~TakenLock() {
  PyGILState_Release(state_);
  ++at_work;
}

PyObject* call_python(PyObject* function, PyObject* argument) {
  try {
    return PyObject_CallOneArg(function, argument);
  } catch (abi::__forced_unwind&) {
    wait_for_end();
  }
}

}  // namespace pinball::python
