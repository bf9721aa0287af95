#pragma once
/// Checkpoints: one HDF5 file a rank, then a manifest with their sizes and hashes. A checkpoint is
/// there when its manifest is; nothing is trusted when it is read.
///   checkpoint-000000001234.0.h5          tables and texts of rank 0
///   checkpoint-000000001234.manifest      header, files, hashes; a hash of itself in its last line
/// HDF5 works in memory only (chunked, Fletcher's checksum, format 1.10): the bytes that are hashed
/// are the bytes that are written, and those that are read. Files are whole or not there.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "core/state.hpp"

namespace brunt {

/// A checkpoint that is not whole or not one; the message names the file.
class CheckpointError : public MachineError {
 public:
  CheckpointError(const std::filesystem::path& file, const std::string& reason)
      : MachineError("refused the checkpoint '" + file.string() + "': " + reason) {}
};

struct CheckpointHeader {
  std::string program;    ///< version of brunt that wrote it
  std::string deck_hash;  ///< of the resolved deck
  Real time = 0;          ///< [s]
  std::uint64_t step = 0;
  std::uint64_t ranks = 1;
  bool operator==(const CheckpointHeader&) const = default;
};

/// What one rank writes.
struct CheckpointContent {
  std::vector<StateTable> tables;
  std::map<std::string, std::string> texts;  ///< any bytes, by name
};

/// A rank's file as it was written.
struct CheckpointPart {
  std::uint64_t bytes = 0;
  std::uint64_t hash = 0;
};

/// What was read: tables of all ranks, texts of the first.
struct Checkpoint {
  CheckpointHeader header;
  CheckpointContent content;
};

std::filesystem::path checkpoint_manifest(const std::filesystem::path& folder, std::uint64_t step);
std::filesystem::path checkpoint_part(const std::filesystem::path& folder, std::uint64_t step,
                                      std::uint64_t rank);
/// The manifest of a file of a checkpoint, by its name.
std::filesystem::path manifest_of(const std::filesystem::path& file);
/// True for the names of manifests, parts and what is left of their temporaries.
bool is_checkpoint_file(const std::filesystem::path& file);

/// Writes the file of one rank. Moves of the content save its memory. Throws MachineError.
CheckpointPart write_checkpoint_part(const std::filesystem::path& folder,
                                     const CheckpointHeader& header, std::uint64_t rank,
                                     CheckpointContent content);
/// Makes the parts of all ranks a checkpoint; called once, when all parts are written. Throws
/// MachineError.
void write_checkpoint_manifest(const std::filesystem::path& folder, const CheckpointHeader& header,
                               const std::vector<CheckpointPart>& parts);

/// Reads a checkpoint whole and checks all of it. manifest: its path. Throws CheckpointError.
Checkpoint read_checkpoint(const std::filesystem::path& manifest);

/// Manifests in a folder, the latest step first; good or not.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);
/// Takes away all files of checkpoints but those of the steps `kept`. Throws MachineError.
void remove_checkpoints_but(const std::filesystem::path& folder,
                            const std::vector<std::uint64_t>& kept);
/// Takes away checkpoints of later steps than this one, in its folder. Throws MachineError.
void remove_checkpoints_after(const std::filesystem::path& manifest);

}  // namespace brunt
