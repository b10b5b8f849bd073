#pragma once

#include "deployment/store_source.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace opal {

/// What drives say, on its way to a map store: it stays on this machine until the store has confirmed it. A file each,
/// written whole or not at all.
class EvidenceOutbox {
 public:
  /// OPAL_OUTBOX, or opal/outbox in XDG_STATE_HOME, or in ~/.local/state.
  /// @throws Error if there is no such folder, because there is no home.
  static EvidenceOutbox usual();
  /// @param folder  made when needed.
  explicit EvidenceOutbox(std::filesystem::path folder) : folder_(std::move(folder)) {}

  struct Entry {
    std::string file;
    StoreSource version;   ///< that the drive was compared with
    std::string document;  ///< JSON, a drive
  };

  /// @param where  which store: MapStore::where(). The same document again is the same entry.
  /// @throws WriteError if it cannot be written.
  void keep(const std::string& where, const StoreSource& version, const std::string& document) const;
  /// Everything that waits for a store, in the order of the file names.
  /// @throws Error naming a file that is none of an outbox.
  std::vector<Entry> waiting_for(const std::string& where) const;
  /// The store has it.
  static void confirm(const Entry& entry);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_of(const std::string& where) const;
  std::filesystem::path folder_;
};

}  // namespace opal
