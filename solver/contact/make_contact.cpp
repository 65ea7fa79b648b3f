#include <utility>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/pinball/pinball_algorithm.hpp>
#include <solver/contact/slideline/slideline_algorithm.hpp>

namespace pinball {

template <class S>
std::unique_ptr<ContactAlgorithm<S>> make_contact(const ContactModel<S>& model, ContactStart start) {
  if (model.settings->method == ContactMethod::slideline) {
    return std::make_unique<SlidelineContact<S>>(model, std::move(start));
  }
  return std::make_unique<PinballContact<S>>(model, std::move(start));
}

template std::unique_ptr<ContactAlgorithm<double>> make_contact(const ContactModel<double>&, ContactStart);
template std::unique_ptr<ContactAlgorithm<float>> make_contact(const ContactModel<float>&, ContactStart);

}  // namespace pinball
