#include "fleet/evidence_outbox.hpp"

#include "common/digest/sha256.hpp"
#include "common/text_file.hpp"
#include "common/whole_file.hpp"
#include "deployment/cache_folder.hpp"

#include <opal/common/error.hpp>
#include <opal/common/strict_json.hpp>

#include <algorithm>
#include <optional>
#include <system_error>

namespace opal {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

EvidenceOutbox::Entry entry_of(const std::string& file) {
  const json kept = read_json(file);
  try {
    return {file, {kept.at("building"), kept.at("version")}, kept.at("document")};
  } catch (const json::exception& error) {
    throw Error(file + ": is no evidence that Opal keeps for a map store: " + error.what());
  }
}

/// Nothing, if another program has sent it in the meantime.
std::optional<EvidenceOutbox::Entry> entry_if_there(const std::string& file) try {
  return entry_of(file);
} catch (const Error&) {
  if (fs::exists(file)) throw;
  return std::nullopt;
}

}  // namespace

EvidenceOutbox EvidenceOutbox::usual() {
  const fs::path folder = state_folder("OPAL_OUTBOX", "outbox");
  if (!folder.empty()) return EvidenceOutbox(folder);
  throw Error("no folder for what waits for the map store: neither OPAL_OUTBOX, XDG_STATE_HOME nor HOME names one");
}

fs::path EvidenceOutbox::folder_of(const std::string& where) const { return folder_ / sha256_of(where).substr(0, 16); }

void EvidenceOutbox::keep(const std::string& where, const StoreSource& version, const std::string& document) const {
  const json kept{
      {"where", where}, {"building", version.building}, {"version", version.version}, {"document", document}};
  const std::string text = kept.dump(1) + '\n';
  make_folder(folder_of(where).string());
  write_text((folder_of(where) / (sha256_of(text) + ".json")).string(), text);
}

std::vector<EvidenceOutbox::Entry> EvidenceOutbox::waiting_for(const std::string& where) const {
  std::vector<std::string> files;
  if (fs::exists(folder_of(where)))
    for (const fs::directory_entry& file : fs::directory_iterator(folder_of(where)))
      if (file.path().extension() == ".json") files.push_back(file.path().string());
  std::sort(files.begin(), files.end());
  std::vector<Entry> entries;
  for (const std::string& file : files)
    if (auto entry = entry_if_there(file)) entries.push_back(std::move(*entry));
  return entries;
}

void EvidenceOutbox::confirm(const Entry& entry) {
  std::error_code stays;  // sent once more the next time, which does no harm
  fs::remove(entry.file, stays);
}

}  // namespace opal
