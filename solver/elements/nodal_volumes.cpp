#include "nodal_volumes.hpp"

#include <span>

#include <kernels/exec.hpp>

namespace pinball {

template <class S>
NodalVolumes<S>::NodalVolumes(const Model<S>& model, Subdomain<S>* domain) : domain_(domain), groups_(model, domain) {
  for (const VolumeNeighbour& of : groups_.neighbours) sent_.emplace_back(of.sent.size());
}

template <class S>
void NodalVolumes<S>::average(Model<S>& model) {
  if (!any()) return;
  find_volumes_of(model, groups_.lists, groups_.own);
  if (domain_ != nullptr) exchange();
  if (model.elements.single) {
    average_in<float>(model);
  } else {
    average_in<S>(model);
  }
}

/// Volumes that another rank has found come behind those of this one.
template <class S>
void NodalVolumes<S>::exchange() {
  if (groups_.sent_by_all == 0) return;
  S* const volume = groups_.lists.volume.data();
  std::vector<RankMessage> messages;
  for (std::size_t n = 0; n < sent_.size(); ++n) {
    const VolumeNeighbour& of = groups_.neighbours[n];
    parallel_for("volumes for another rank", RangePolicy<>{0, std::ssize(of.sent)},
                 [&](std::int64_t i) { sent_[n][i] = volume[of.sent[i]]; });
    const std::span<S> received(volume + of.first, of.count);
    messages.push_back({of.rank, std::as_bytes(std::span(sent_[n])), std::as_writable_bytes(received)});
  }
  domain_->exchange(messages, groups_.sent_by_all * static_cast<std::int64_t>(sizeof(S)));
}

template <class S>
template <class E>
void NodalVolumes<S>::average_in(Model<S>& model) {
  const ElementView<E> elements = model.elements.template view<E>();
  average_volumes<DefaultExecutionSpace, native_width<E>>(groups_.lists.view(), groups_.own, groups_.lists.groups(),
                                                          elements.volume_ratio);
}

template <class S>
std::size_t NodalVolumes<S>::bytes() const {
  std::size_t sum = groups_.lists.bytes();
  for (const VolumeNeighbour& of : groups_.neighbours) sum += of.sent.size() * (sizeof(std::int32_t) + sizeof(S));
  return sum;
}

template class NodalVolumes<double>;
template class NodalVolumes<float>;

}  // namespace pinball
