#pragma once

#include <string>
#include <vector>

/// The sentences as one text, to look for one of them.
inline std::string text(const std::vector<std::string>& sentences) {
  std::string all;
  for (const std::string& sentence : sentences) all += sentence + "\n";
  return all;
}
