#pragma once

#include "output/unfinished_run.hpp"

#include <opal/common/error.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace opal {

/// Another program writes into a folder. The message names the folder and who it is.
class FolderInUse : public Error {
 public:
  using Error::Error;
};

/// The folder of one run. It belongs to this run alone, and is marked as unfinished until `finish`
/// (unfinished_run.hpp). What earlier runs left of the same names is removed, so that nothing old stands beside what is
/// new.
class OutputFolder {
 public:
  /// Makes the folder.
  /// @param command   "opal localize", for whoever finds the folder in use or unfinished.
  /// @param products  names of the files that the run may write, `*` for any text in them.
  /// @throws FolderInUse, WriteError
  OutputFolder(const std::filesystem::path& path, const std::string& command, const std::vector<std::string>& products);
  /// The folder stays marked unless the run was finished.
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }

  /// Everything is written: the mark goes.
  void finish();
  /// The run ends early with what it has: the mark stays, and says so.
  void interrupt(int signal);

 private:
  void lock();
  bool try_lock();
  void remove_old(const std::vector<std::string>& products) const;
  void mark() const;
  void release();
  void give_up();

  std::filesystem::path path_;
  std::string marker_;
  UnfinishedRun run_;
  int file_ = -1;
};

/// "SIGINT", or the number of a signal that has no name here.
std::string signal_name(int signal);

}  // namespace opal
