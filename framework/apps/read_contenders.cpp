#include "read_contenders.hpp"

#include "session.hpp"

#include <filesystem>

std::vector<opal::experiments::Contender> read_contenders(const std::vector<std::string>& configs) {
  std::vector<opal::experiments::Contender> all;
  for (const std::string& config : configs) {
    const bool is_file = config.ends_with(".jsonld");
    all.push_back({is_file ? std::filesystem::path(config).stem().string() : config,
                   opal::read_deployment(is_file ? config : shipped_config(config + ".jsonld")), ""});
  }
  return all;
}
