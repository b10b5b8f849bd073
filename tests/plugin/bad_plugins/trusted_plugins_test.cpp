#include "plugin_files.hpp"

#include "common/digest/sha256.hpp"
#include "common/text_file.hpp"
#include "plugin/described_library.hpp"
#include "tests/kit/refusal.hpp"

#include <opal/common/error.hpp>
#include <opal/plugin/plugin_registry.hpp>
#include <opal/sensing/feature_detector.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <functional>

using namespace opal;
using namespace opal_test;
using Catch::Contains;
using Catch::StartsWith;

namespace {

constexpr const char* kTrace = "OPAL_TEST_GOOD_WAS_OPENED";

bool good_was_opened() { return std::getenv(kTrace) != nullptr; }

/// Of the plugin "good", in a folder of its own.
class TrustedGood {
 public:
  TrustedGood() : file_(folder_.copy(bad_plugin("good.so"))), digest_(sha256_of_file(file_)) {
    folder_.copy(bad_plugin("good.jsonld"));
    unsetenv(kTrace);
    registry_.announce(file_);
  }

  const std::string& file() const { return file_; }
  const std::string& digest() const { return digest_; }
  const PluginRegistry& all() const { return registry_; }
  TrustedPlugins list(const std::string& digest) const {
    return {"a.jsonld: /trusted_plugins", {{"good", {digest, "a.jsonld: /trusted_plugins/0/sha256"}}}, {}, {}};
  }
  PluginRegistry trusting(const std::string& digest) const { return registry_.trusting(list(digest)); }
  /// The list of its library as it is, and of a description with this digest.
  PluginRegistry trusting_description(const std::string& digest) const {
    TrustedPlugins trusted = list(digest_);
    trusted.descriptions["good"] = {digest, "a.jsonld: /trusted_plugins/0/description_sha256"};
    return registry_.trusting(trusted);
  }
  std::string description_file() const { return opal::description_file(file_); }
  /// Another file in its place, with another bit in the middle, which is still a library.
  void change_a_byte() const {
    std::string bytes = content_of(file_);
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
    std::filesystem::rename(folder_.write("other.so", bytes), file_);
  }

 private:
  PluginFolder folder_;
  std::string file_, digest_;
  PluginRegistry registry_;
};

std::string making_refusal(const PluginRegistry& registry) {
  return refused_with<ConfigError>([&] { registry.make<FeatureDetector>("bad:good"); });
}

}  // namespace

TEST_CASE("a plugin with the digest that a list expects is made") {
  const TrustedGood good;
  const PluginRegistry registry = good.trusting(good.digest());
  CHECK_NOTHROW(registry.expect_trusted("bad:good"));
  CHECK(registry.is_listed("bad:good"));
  CHECK_FALSE(good_was_opened());
  CHECK(registry.make<FeatureDetector>("bad:good") != nullptr);
  CHECK(good_was_opened());
}

TEST_CASE("a plugin whose file was changed by one bit is refused before any of its code runs") {
  const TrustedGood good;
  const PluginRegistry registry = good.trusting(good.digest());
  good.change_a_byte();
  const std::string found = sha256_of_file(good.file());
  const std::string expected = "a.jsonld: /trusted_plugins/0/sha256: plugin good: " + good.file() + " has SHA-256 " +
                               found + ", expected " + good.digest() + ": it is not the file that is trusted";
  CHECK(making_refusal(registry) == expected);
  CHECK(refused_with<ConfigError>([&] { registry.expect_trusted("bad:good"); }) == expected);
  CHECK(registry.is_listed("bad:good"));
  CHECK_FALSE(good_was_opened());
}

TEST_CASE("a plugin with another description than the trusted one is refused before any of its code runs") {
  const TrustedGood good;
  const std::string found = sha256_of_file(good.description_file()), other(64, '0');
  const PluginRegistry registry = good.trusting_description(other);
  CHECK(making_refusal(registry) ==
        "a.jsonld: /trusted_plugins/0/description_sha256: plugin good: " + good.description_file() + " has SHA-256 " +
            found + ", expected " + other + ": it is not the file that is trusted");
  CHECK_FALSE(good_was_opened());
  CHECK(making_refusal(good.trusting_description(found)) == "accepted");
}

TEST_CASE("a description counts as it was read, not as its file is later") {
  const TrustedGood good;
  const std::string read = sha256_of_file(good.description_file());
  write_text(good.description_file(), "{}");
  CHECK(making_refusal(good.trusting_description(read)) == "accepted");
  CHECK_THAT(making_refusal(good.trusting_description(sha256_of_file(good.description_file()))),
             Contains("description_sha256: plugin good: "));
}

TEST_CASE("a plugin that is changed after it was checked, before it is opened, is refused") {
  const TrustedGood good;
  const PluginRegistry registry = good.trusting(good.digest());
  registry.expect_trusted("bad:good");
  good.change_a_byte();
  CHECK_THAT(making_refusal(registry), Contains("it is not the file that is trusted"));
  CHECK_FALSE(good_was_opened());
}

TEST_CASE("a plugin that is not in the list is refused before any of its code runs") {
  const TrustedGood good;
  const PluginRegistry registry =
      good.all().trusting(TrustedPlugins{"a.jsonld: /trusted_plugins", {{"lines", {good.digest(), ""}}}, {}, {}});
  CHECK(making_refusal(registry) == "a.jsonld: /trusted_plugins: plugin good: " + good.file() + " has SHA-256 " +
                                        good.digest() + " and is not in the list, expected one of: lines");
  CHECK_FALSE(registry.is_listed("bad:good"));
  CHECK_FALSE(good_was_opened());
}

TEST_CASE("an empty list trusts nothing, and no list trusts all") {
  const TrustedGood good;
  const PluginRegistry none = good.all().trusting(TrustedPlugins{"a.jsonld: /trusted_plugins", {}, {}, {}});
  CHECK_THAT(making_refusal(none), Contains("is not in the list, expected one of: none"));
  CHECK(making_refusal(good.all().trusting(std::nullopt)) == "accepted");
}

TEST_CASE("a second list does not widen the first") {
  const TrustedGood good;
  const std::string wrong(64, '0');
  CHECK_THAT(making_refusal(good.trusting(wrong).trusting(good.list(good.digest()))), Contains("expected " + wrong));
  CHECK_THAT(making_refusal(good.trusting(good.digest()).trusting(good.list(wrong))), Contains("expected " + wrong));
  CHECK_THAT(making_refusal(good.trusting(wrong).trusting(std::nullopt)), Contains("expected " + wrong));
}

TEST_CASE("a library that is open stays what it was when it was checked") {
  const TrustedGood good;
  const PluginRegistry registry = good.trusting(good.digest());
  registry.make<FeatureDetector>("bad:good");
  good.change_a_byte();
  CHECK(making_refusal(registry) == "accepted");
}

TEST_CASE("a registry that trusts a list loads nothing else") {
  const TrustedGood good;
  PluginRegistry none = PluginRegistry().trusting(TrustedPlugins{"a.jsonld: /trusted_plugins", {}, {}, {}});
  CHECK_THAT(refused_with<ConfigError>([&] { none.load(good.file()); }),
             Contains("plugin good") && Contains("is not in the list"));
  CHECK_THAT(refused_with<ConfigError>([&] { none.load_all(std::filesystem::path(good.file()).parent_path()); }),
             StartsWith("a.jsonld: /trusted_plugins: plugin good"));
  CHECK_FALSE(good_was_opened());
  CHECK_FALSE(none.has("bad:good"));
  PluginRegistry one = PluginRegistry().trusting(good.list(good.digest()));
  one.load(good.file());
  CHECK(one.has("bad:good"));
}
