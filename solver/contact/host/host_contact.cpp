#include "host_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <solver/base/thread_count.hpp>
#include <solver/contact/algorithm/contact_ledger.hpp>

#include "host_error.hpp"
#include "host_options.hpp"
#include "sphere_holes.hpp"

namespace pinball {

namespace {

template <class S, class Vectors>
void require_vectors(const Vectors& vectors, std::int64_t nodes, const char* name) {
  for (const void* component : {static_cast<const void*>(vectors.x), static_cast<const void*>(vectors.y),
                                static_cast<const void*>(vectors.z)}) {
    require_pointer(component, name);
  }
  require_stride<S>(vectors.stride, nodes, message_of(name, ".").c_str());
}

void require_step(double dt, const char* name) {
  if (dt >= 0 && is_sound(dt)) return;
  throw HostError(PINBALL_CONTACT_BAD_NUMBER, name, ": expected a number >= 0 with a finite square, got ", dt);
}

template <class S>
class HostContactOf final : public HostContact {
 public:
  HostContactOf(const ContactSettings& settings, const pinball_contact_options& options, HostMesh<S> mesh,
                const pinball_contact_input& position)
      : threads_(options.threads), source_(options, std::move(mesh), position) {
    const ThreadCount threads(threads_);
    contact_ =
        make_contact<S>(settings, source_, source_.start(position, settings.enforcement != Enforcement::penalty));
    warning_ = sphere_holes<S>(settings, source_, contact_->surface());
  }

  void update(const pinball_contact_arrays* arrays, double dt_before) override {
    check(arrays);
    require_step(dt_before, "dt_before");
    if (updated_) throw HostError(PINBALL_CONTACT_BAD_ORDER, "update: the last one still waits for add_forces");
    const ThreadCount threads(threads_);
    const std::vector<std::int64_t> eroded = source_.update_alive(*arrays, contact_->surface());
    eroded_.insert(eroded_.end(), eroded.begin(), eroded.end());
    std::sort(eroded_.begin(), eroded_.end());
    source_.gather_motion(*arrays, eroded_.empty() ? contact_->listed_nodes() : nullptr);
    contact_->update_surface(source_, eroded_);
    eroded_.clear();
    dt_before_ = dt_before;
    // The first step has none before it: how much closes in it is known when its length is.
    waits_ = contact_->looks_ahead() && dt_before == 0;
    if (!waits_) look(0);
    updated_ = true;
  }

  pinball_contact_result add_forces(const pinball_contact_arrays* arrays, double dt_after) override {
    check(arrays);
    require_vectors<S>(arrays->force, source_.node_count, "arrays->force");
    check_force_records(*arrays);
    require_step(dt_after, "dt_after");
    if (!updated_) throw HostError(PINBALL_CONTACT_BAD_ORDER, "add_forces: expected update before it");
    const ThreadCount threads(threads_);
    if (waits_ || (contact_->looks_ahead() && dt_after > 2 * dt_before_)) look_further(*arrays, dt_after);
    ContactWork work = springs_;
    if (work.pairs > 0) add_springs(*arrays, work);
    work += add_impulses(*arrays, dt_after);
    ledger_.book(work, dt_before_);
    updated_ = false;
    return result_of(work);
  }

  std::int32_t surface_elements() const override { return contact_->surface_elements(); }
  const std::string& warning() const override { return warning_; }

 private:
  void check(const pinball_contact_arrays* arrays) const {
    require_version(arrays, "arrays");
    require_vectors<S>(arrays->position, source_.node_count, "arrays->position");
    require_vectors<S>(arrays->velocity, source_.node_count, "arrays->velocity");
  }

  static void check_force_records(const pinball_contact_arrays& arrays) {
    const pinball_contact_output& f = arrays.force;
    if (arrays.force_records == 0) return;
    if (arrays.force_records != 1 || !HostVectors<S>({f.x, f.y, f.z, f.stride}).are_records()) {
      throw HostError(PINBALL_CONTACT_BAD_OPTION,
                      "arrays->force_records: expected 0, or 1 where arrays->force are aligned records of four");
    }
  }

  void look(double dt_coming) {
    contact_->expect({.dt = dt_coming});
    contact_->search(source_, dt_before_);
    springs_ = contact_->before_step(source_, dt_before_);
  }

  /// What closes in a step is looked for by the step before, which may have been much shorter.
  void look_further(const pinball_contact_arrays& arrays, double dt_after) {
    source_.gather_motion(arrays, nullptr);
    look(dt_after);
  }

  void add_springs(const pinball_contact_arrays& arrays, ContactWork& work) {
    const std::vector<std::int32_t>& nodes = contact_->spring_nodes();
    source_.gather_forces(arrays, nodes);
    contact_->add_forces(source_, work);
    source_.scatter_forces(arrays, nodes);
  }

  ContactWork add_impulses(const pinball_contact_arrays& arrays, double dt_after) {
    const std::vector<std::int32_t>& nodes = contact_->impulse_nodes();
    source_.gather_impulse_nodes(arrays, nodes);
    const ContactWork work = contact_->after_constraints(source_, {dt_before_, dt_after});
    source_.scatter_forces(arrays, nodes);
    return work;
  }

  /// What a host hears of a step that is booked.
  pinball_contact_result result_of(const ContactWork& now) const {
    pinball_contact_result result{};
    result.stored = now.stored;
    result.dissipated = ledger_.dissipated();
    result.eroded = ledger_.eroded();
    result.damped_power = ledger_.damped_power();
    result.penetration_ratio = now.penetration_ratio;
    result.pairs = now.pairs;
    result.listed_pairs = contact_->listed().entries;
    result.surface_elements = contact_->surface_elements();
    result.searches = contact_->searches();
    result.searches_skipped = contact_->searches_skipped();
    result.frequency2 = now.frequency2;
    result.stable_step = now.frequency2 > 0 ? 2 / std::sqrt(now.frequency2) : std::numeric_limits<double>::infinity();
    return result;
  }

  std::int32_t threads_;
  HostSurface<S> source_;
  std::unique_ptr<ContactAlgorithm<S>> contact_;
  std::vector<std::int64_t> eroded_;  ///< slots that contact does not know of yet
  ContactWork springs_;               ///< of update, whose forces add_forces adds
  double dt_before_ = 0;
  bool updated_ = false;  ///< add_forces is due
  bool waits_ = false;    ///< and has to look for what may touch
  ContactLedger ledger_;
  std::string warning_;
};

template <class S>
std::unique_ptr<HostContact> make_of(const ContactSettings& settings, const pinball_contact_options& options,
                                     const pinball_contact_mesh* mesh, const pinball_contact_input* position) {
  HostMesh<S> checked(options, mesh, position);
  return std::make_unique<HostContactOf<S>>(settings, options, std::move(checked), *position);
}

}  // namespace

std::unique_ptr<HostContact> make_host_contact(const pinball_contact_options* options, const pinball_contact_mesh* mesh,
                                               const pinball_contact_input* position) {
  const ContactSettings settings = settings_of(options);
  return options->number == PINBALL_CONTACT_FLOAT ? make_of<float>(settings, *options, mesh, position)
                                                  : make_of<double>(settings, *options, mesh, position);
}

}  // namespace pinball
