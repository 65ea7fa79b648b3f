#include <utility>

#include <solver/contact/algorithm/contact_algorithm.hpp>
#include <solver/contact/faces/face_algorithm.hpp>
#include <solver/contact/pinball/pinball_algorithm.hpp>
#include <solver/contact/slideline/slideline_algorithm.hpp>

namespace pinball {

template <class S>
std::unique_ptr<ContactAlgorithm<S>> make_contact(const ContactSettings& settings, const SurfaceSource<S>& source,
                                                  InitialSurface start) {
  if (settings.method == ContactMethod::slideline) {
    return std::make_unique<SlidelineAlgorithm<S>>(settings, source, std::move(start));
  }
  if (settings.gap == ContactGap::face && settings.enforcement != Enforcement::penalty) {
    return std::make_unique<FaceAlgorithm<S>>(settings, source, std::move(start));
  }
  return std::make_unique<PinballAlgorithm<S>>(settings, source, std::move(start));
}

template std::unique_ptr<ContactAlgorithm<double>> make_contact(const ContactSettings&, const SurfaceSource<double>&,
                                                                InitialSurface);
template std::unique_ptr<ContactAlgorithm<float>> make_contact(const ContactSettings&, const SurfaceSource<float>&,
                                                               InitialSurface);

}  // namespace pinball
