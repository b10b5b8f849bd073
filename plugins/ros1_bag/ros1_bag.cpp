#include "ros1_bag.hpp"

#include "bag_recording.hpp"

namespace opal::ros1_bag {

bool Ros1Bag::recognizes_file(const std::string& file) const { return is_bag(file); }

std::unique_ptr<recording::Recording> Ros1Bag::read(const std::string& file) const { return read_bag(file); }

}  // namespace opal::ros1_bag
