#include "deployment/cache_folder.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <optional>
#include <string>

using namespace opal;

namespace {

/// Sets a variable of the environment, or removes it, until the end of a test.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* was = std::getenv(name)) was_ = was;
    set(value);
  }
  ~Variable() { set(was_ ? was_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) const {
    if (value != nullptr)
      setenv(name_, value, 1);
    else
      unsetenv(name_);
  }
  const char* name_;
  std::optional<std::string> was_;
};

constexpr const char* kOwn = "OPAL_TEST_CACHE";

}  // namespace

TEST_CASE("what can be made again is kept where its own variable says, or the cache of the user is") {
  const Variable none(kOwn, nullptr), cache("XDG_CACHE_HOME", "/caches"), home("HOME", "/home/somebody");
  CHECK(cache_folder(kOwn, "maps") == "/caches/opal/maps");
  {
    const Variable own(kOwn, "/somewhere");
    CHECK(cache_folder(kOwn, "maps") == "/somewhere");
  }
  const Variable no_cache("XDG_CACHE_HOME", "");
  CHECK(cache_folder(kOwn, "maps") == "/home/somebody/.cache/opal/maps");
}

TEST_CASE("nothing is kept if the variable is empty, or if there is no home") {
  const Variable home("HOME", "/home/somebody");
  {
    const Variable own(kOwn, "");
    CHECK(cache_folder(kOwn, "maps").empty());
  }
  const Variable none(kOwn, nullptr), no_cache("XDG_CACHE_HOME", nullptr), no_home("HOME", nullptr);
  CHECK(cache_folder(kOwn, "maps").empty());
}
