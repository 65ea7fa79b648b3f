#include <cmath>
#include <pinball/built_features.hpp>
#include <pinball/solver/contact.hpp>
#include <pinball/solver/pinball_contact.hpp>
#include <pinball/solver/slideline_contact.hpp>

namespace pinball {

template <class S>
Contact<S>::Contact(const Model<S>& model) {
  // A damped spring is stable for dt <= 2/w (sqrt(1 + xi^2) - xi): as an undamped one of the higher frequency.
  const double xi = model.scene.contact.damping;
  damping_factor_ = 1.0 / std::pow(std::sqrt(1 + xi * xi) - xi, 2);
  if (model.scene.contact.enforcement != Enforcement::penalty) impulses_ = std::make_unique<ContactImpulses<S>>(model);
}

template <class S>
ContactResult Contact<S>::impulses(Model<S>& model, const StepLengths& step) {
  const ImpulseResult solved = impulses_->solve(model, step);
  ContactResult result;
  result.dissipated = solved.dissipated;
  result.penetration_ratio = solved.penetration_ratio;
  result.pairs = solved.pairs;
  return result;
}

template <class S>
std::unique_ptr<Contact<S>> make_contact([[maybe_unused]] const Model<S>& model) {
  if constexpr (built::contact) {
    switch (model.scene.contact.method) {
      case ContactMethod::none:
        return nullptr;
      case ContactMethod::pinball:
        return std::make_unique<PinballContact<S>>(model);
      case ContactMethod::slideline:
        return std::make_unique<SlidelineContact<S>>(model);
    }
  }
  return nullptr;
}

template class Contact<double>;
template class Contact<float>;
template std::unique_ptr<Contact<double>> make_contact(const Model<double>&);
template std::unique_ptr<Contact<float>> make_contact(const Model<float>&);

}  // namespace pinball
