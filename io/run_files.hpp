#pragma once
/// What a run has made in its output folder, by name, and the lock that keeps a second run out.
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace brunt {

/// The list of a folder: a heading, then a name a line, relative to the folder. Names are added
/// before the files are made, so that a run that was killed leaves none unlisted. Its file is the
/// lock too, and therefore never replaced.
inline constexpr const char* kRunFiles = "brunt-files.txt";

/// Adds names to the list; does nothing where the folder has none. Throws MachineError.
void list_files(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Begins the list anew: those that every run makes, and `names`. Throws MachineError.
void begin_list(const std::filesystem::path& folder, const std::vector<std::string>& names);

/// Which files of a folder a run of brunt has made.
class RunFiles {
 public:
  /// Reads the list. In the folder of a run that kept none, the names that brunt gives count, and
  /// pictures do not.
  explicit RunFiles(std::filesystem::path folder);
  bool has_list() const { return listed_.has_value(); }
  /// True for a plain file (no link, no folder) that a run has made, or a temporary of one.
  bool own(const std::string& name) const;
  /// All of them that are there, in the folder and in its frames.
  std::vector<std::string> present() const;

 private:
  std::filesystem::path folder_;
  std::optional<std::set<std::string>> listed_;
  bool old_run_ = false;  // has files of a run, and no list
};

/// Names that a run replaces at its start and that stand there without being a run's.
std::vector<std::string> in_the_way(const std::filesystem::path& folder);

/// Takes away what runs have made in the folder, but `kept`, and nothing else; `under` limits it
/// to names that begin so. Throws MachineError.
void remove_run_files(const std::filesystem::path& folder, const std::string& under = "",
                      const std::set<std::string>& kept = {});

/// Held while a run writes to its folder; the system lets go of it when the process ends, however
/// it does. Taken by the root of all ranks.
class FolderLock {
 public:
  /// Throws DeckError where another run holds it, MachineError where the file cannot be opened. On
  /// file systems without locks it warns and goes on.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// True where a run holds the lock of a folder now. It asks by taking the lock for a moment, which
/// a run that begins waits for.
bool is_locked(const std::filesystem::path& folder);

}  // namespace brunt
