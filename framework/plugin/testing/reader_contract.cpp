#include <opal/plugin/testing/reader_contract.hpp>

#include "plugin/testing/violations.hpp"

#include <opal/common/error.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

namespace opal::testing {
namespace {

namespace fs = std::filesystem;

/// Files that no reader can use, in a folder that goes away with this.
class UselessFiles {
 public:
  UselessFiles() {
    std::string pattern = (fs::temp_directory_path() / "opal_contract_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern + ": cannot make a folder for the contract's files");
    folder_ = pattern;
    fs::create_directory(folder_ / "folder");
    std::ofstream empty(folder_ / "empty.bin");
    std::ofstream noise(folder_ / "noise.bin", std::ios::binary);
    std::mt19937 random(3);
    for (int i = 0; i < 4096; ++i) noise.put(static_cast<char>(random()));
  }
  ~UselessFiles() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  UselessFiles(const UselessFiles&) = delete;
  UselessFiles& operator=(const UselessFiles&) = delete;

  std::vector<std::pair<std::string, std::string>> named() const {
    return {{"a missing file", (folder_ / "missing.bin").string()},
            {"a folder", (folder_ / "folder").string()},
            {"an empty file", (folder_ / "empty.bin").string()},
            {"a file of noise", (folder_ / "noise.bin").string()}};
  }

 private:
  fs::path folder_;
};

/// Expects a call to throw `Expected`, with the path in its message.
template <class Expected, class Call>
void expect_refusal(Violations& violations, const std::string& name, const std::string& path, Call&& call) {
  try {
    call();
    violations.add("accepts", "accepts " + name + ", expected an error");
  } catch (const Expected& error) {
    if (std::string(error.what()).find(path) == std::string::npos)
      violations.add("unnamed", "refuses " + name + " without naming it: " + error.what());
  } catch (const std::exception& error) {
    violations.add("kind", "refuses " + name + " with an error of the wrong kind: " + error.what());
  } catch (...) {
    violations.add("kind", "refuses " + name + " with something that is no std::exception");
  }
}

template <class Reader>
void check_recognition(Violations& violations, const Reader& reader, const std::string& name, const std::string& path) {
  violations.expect_no_throw("looking at " + name, [&] {
    if (reader.recognizes(path)) violations.add("recognizes", "recognises " + name + " as its own");
  });
}

/// What cannot be played may still be looked at.
void check_useless_contents(Violations& violations, const LogSource& source, const std::string& name,
                            const std::string& path) {
  violations.expect_no_throw("telling the contents of " + name, [&] {
    try {
      if (!source.contents(path).lasers.empty()) violations.add("lasers", "finds a laser in " + name);
    } catch (const LogError&) {
      return;
    }
  });
}

/// A log may be empty or damaged throughout: refused as a whole, or read to its end.
void check_useless_log(Violations& violations, const LogSource& source, const std::string& name,
                       const std::string& path) {
  violations.expect_no_throw("reading " + name, [&] {
    try {
      const auto reader = source.open(path);
      if (reader == nullptr) return violations.add("null", "opens " + name + " and returns null");
      for (int records = 0; reader->next(); ++records)
        if (records > 4096) return violations.add("endless", "finds more records in " + name + " than it has bytes");
      if (!(reader->progress() >= 0 && reader->progress() <= 1))
        violations.add("progress", "reports a progress of " + std::to_string(reader->progress()) + " in " + name);
    } catch (const LogError&) {
      return;
    }
  });
}

}  // namespace

std::vector<std::string> log_source_violations(const LogSource& source, const TypeInfo& type) {
  Violations violations(type.name);
  const UselessFiles files;
  for (const auto& [name, path] : files.named()) {
    check_recognition(violations, source, name, path);
    check_useless_contents(violations, source, name, path);
    if (fs::is_regular_file(path))
      check_useless_log(violations, source, name, path);
    else
      expect_refusal<LogError>(violations, name, path, [&, &file = path] { source.open(file); });
  }
  return violations.take();
}

std::vector<std::string> map_importer_violations(const MapImporter& importer, const TypeInfo& type) {
  Violations violations(type.name);
  const UselessFiles files;
  for (const auto& [name, path] : files.named()) {
    check_recognition(violations, importer, name, path);
    expect_refusal<MapError>(violations, name, path, [&, &file = path] { importer.import(file); });
  }
  return violations.take();
}

}  // namespace opal::testing
