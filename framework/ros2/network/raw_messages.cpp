#include "ros2/network/participant.hpp"

#include <dds/ddsi/ddsi_serdata.h>

#include <array>

namespace opal::ros2 {
namespace {

void hand_over(const ddsi_serdata* message, const TakeRaw& take) {
  const std::uint32_t bytes = ddsi_serdata_size(message);
  ddsrt_iovec_t part{};
  ddsi_serdata* const held = ddsi_serdata_to_ser_ref(message, 0, bytes, &part);
  take({static_cast<const std::byte*>(part.iov_base), part.iov_len});
  ddsi_serdata_to_ser_unref(held, &part);
}

}  // namespace

void take_raw(const Entity& reader, const TakeRaw& take) {
  constexpr std::uint32_t kAtOnce = 32;
  std::array<ddsi_serdata*, kAtOnce> messages{};
  std::array<dds_sample_info_t, kAtOnce> infos{};  // NOLINT(*-enum-default-initialization): written before it is read
  const std::uint32_t any = DDS_ANY_SAMPLE_STATE | DDS_ANY_VIEW_STATE | DDS_ANY_INSTANCE_STATE;
  for (dds_return_t count = static_cast<dds_return_t>(kAtOnce); count == static_cast<dds_return_t>(kAtOnce);) {
    count = dds_takecdr(reader.handle(), messages.data(), kAtOnce, infos.data(), any);
    for (std::size_t i = 0; static_cast<dds_return_t>(i) < count; ++i) {
      if (infos[i].valid_data) hand_over(messages[i], take);
      ddsi_serdata_unref(messages[i]);
    }
  }
}

}  // namespace opal::ros2
