#include <cmath>
#include <utility>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/pinball/pinball_algorithm.hpp>
#include <solver/contact/slideline/slideline_algorithm.hpp>

namespace pinball {

template <class S>
Contact<S>::Contact(const ContactModel<S>& model, HeldDirections held) {
  // A damped spring is stable for dt <= 2/w (sqrt(1 + xi^2) - xi): as an undamped one of the higher frequency.
  const double xi = model.settings->damping;
  damping_factor_ = 1.0 / std::pow(std::sqrt(1 + xi * xi) - xi, 2);
  if (model.settings->enforcement != Enforcement::penalty) {
    impulses_ = std::make_unique<ContactImpulses<S>>(model, std::move(held));
  }
}

template <class S>
ContactResult Contact<S>::impulses(const ContactModel<S>& model, const StepLengths& step) {
  const ImpulseResult solved = impulses_->solve(model, step);
  ContactResult result;
  result.dissipated = solved.dissipated;
  result.penetration_ratio = solved.penetration_ratio;
  result.pairs = solved.pairs;
  return result;
}

template <class S>
std::unique_ptr<Contact<S>> make_contact(const ContactModel<S>& model, ContactStart start) {
  if (model.settings->method == ContactMethod::slideline) {
    return std::make_unique<SlidelineContact<S>>(model, std::move(start));
  }
  return std::make_unique<PinballContact<S>>(model, std::move(start));
}

template class Contact<double>;
template class Contact<float>;
template std::unique_ptr<Contact<double>> make_contact(const ContactModel<double>&, ContactStart);
template std::unique_ptr<Contact<float>> make_contact(const ContactModel<float>&, ContactStart);

}  // namespace pinball
