#include "io/checkpoint.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "io/file.hpp"
#include "io/hash.hpp"
#include "io/hdf5_image.hpp"
#include "io/number.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {

constexpr const char* kFirstLine = "brunt checkpoint, format 1";
constexpr const char* kPrefix = "checkpoint-";
constexpr const char* kSuffix = ".manifest";
constexpr std::uintmax_t kLargestManifest = 16u << 20;  // [byte]
constexpr std::size_t kDigits = 12;                     // of a step in a name

std::optional<std::uint64_t> whole(std::string_view text, int base = 10) {
  std::uint64_t number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number, base);
  if (text.empty() || result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return number;
}

std::string stem_of(std::uint64_t step) {
  std::string digits = std::to_string(step);
  if (digits.size() < kDigits) digits.insert(0, kDigits - digits.size(), '0');
  return kPrefix + digits;
}

/// Text that stands in one line of a manifest.
std::string in_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  }
  return text;
}

std::string header_lines(const CheckpointHeader& header) {
  return std::string(kFirstLine) + "\nprogram " + in_line(header.program) + "\ndeck " +
         in_line(header.deck_hash) + "\ntime " + shortest(header.time) + "\nstep " +
         std::to_string(header.step) + "\nranks " + std::to_string(header.ranks) + "\n";
}

struct Manifest {
  CheckpointHeader header;
  std::vector<CheckpointPart> parts;
};

std::string to_text(const Manifest& manifest) {
  std::string text = header_lines(manifest.header);
  for (std::size_t rank = 0; rank < manifest.parts.size(); ++rank) {
    const auto& part = manifest.parts[rank];
    text += "file " + checkpoint_part("", manifest.header.step, rank).string() + " " +
            std::to_string(part.bytes) + " " + hex_digits(part.hash) + "\n";
  }
  return text + "hash " + hex_digits(hash_bytes(text)) + "\n";
}

/// What follows `key` and a space in the next line; empty where there is no such line.
std::string_view take(std::string_view& text, std::string_view key) {
  const auto end = text.find('\n');
  const auto line = text.substr(0, end);
  if (end == std::string_view::npos || !line.starts_with(key)) return {};
  text.remove_prefix(end + 1);
  return line.substr(key.size());
}

/// Reads what to_text wrote. It is right where it gives the same text again.
std::optional<Manifest> manifest_from(const std::string& text) {
  std::string_view rest(text);
  Manifest manifest;
  take(rest, kFirstLine);
  manifest.header.program = take(rest, "program ");
  manifest.header.deck_hash = take(rest, "deck ");
  const auto time = parse_real(take(rest, "time "));
  const auto step = whole(take(rest, "step ")), ranks = whole(take(rest, "ranks "));
  if (!time || !step || !ranks) return std::nullopt;
  manifest.header.time = *time, manifest.header.step = *step, manifest.header.ranks = *ranks;
  while (rest.starts_with("file ")) {
    const auto line = take(rest, "file ");
    const auto hash_at = line.rfind(' ');
    if (hash_at == std::string_view::npos || hash_at == 0) return std::nullopt;
    const auto size_at = line.rfind(' ', hash_at - 1);
    if (size_at == std::string_view::npos) return std::nullopt;
    const auto bytes = whole(line.substr(size_at + 1, hash_at - size_at - 1));
    const auto hash = whole(line.substr(hash_at + 1), 16);
    if (!bytes || !hash) return std::nullopt;
    manifest.parts.push_back({*bytes, *hash});
  }
  if (manifest.parts.size() != manifest.header.ranks || to_text(manifest) != text) {
    return std::nullopt;
  }
  return manifest;
}

/// Bytes of a plain file of a size that is allowed: a pipe could hang, a hole fill the memory.
std::string read_plain(const fs::path& file, std::uintmax_t least, std::uintmax_t most) {
  std::error_code error;
  const auto status = fs::status(file, error);
  if (!fs::exists(status)) throw CheckpointError(file, "it is missing");
  if (!fs::is_regular_file(status)) throw CheckpointError(file, "it is not a file");
  const auto size = fs::file_size(file, error);
  if (error) throw CheckpointError(file, error.message());
  if (size < least || size > most) {
    throw CheckpointError(file, "it has " + std::to_string(size) + " bytes instead of " +
                                    (least == most ? "" : "at most ") + std::to_string(most));
  }
  try {
    return read_file(file);
  } catch (const MachineError& failed) {
    throw CheckpointError(file, failed.what());
  }
}

std::string header_of_part(const CheckpointHeader& header, std::uint64_t rank) {
  return header_lines(header) + "rank " + std::to_string(rank) + "\n";
}

constexpr const char* kHeaderText = "checkpoint.header";

CheckpointContent read_part(const fs::path& file, const Manifest& manifest, std::uint64_t rank) {
  const auto& part = manifest.parts[rank];
  const std::string image = read_plain(file, part.bytes, part.bytes);
  if (hash_bytes(image) != part.hash) throw CheckpointError(file, "its bytes have changed");
  CheckpointContent content;
  try {
    content = from_hdf5(image);
  } catch (const ImageError& error) {
    throw CheckpointError(file, error.what());
  }
  const auto header = content.texts.extract(kHeaderText);
  if (header.empty() || header.mapped() != header_of_part(manifest.header, rank)) {
    throw CheckpointError(file, "it is the file of another rank, step or run");
  }
  return content;
}

/// True for the endings of manifests and parts, and of temporaries of them.
bool ends_as_written(std::string_view ending) {
  constexpr std::string_view kTemporary = ".tmp-XXXXXX";
  const auto cut = ending.size() - std::min(ending.size(), kTemporary.size());
  if (ending.substr(cut).starts_with(".tmp-")) ending = ending.substr(0, cut);
  if (ending == kSuffix) return true;
  if (!ending.starts_with('.') || !ending.ends_with(".h5") || ending.size() < 5) return false;
  return whole(ending.substr(1, ending.size() - 4)).has_value();
}

/// The step in the name of a file of a checkpoint; none for names that brunt does not give.
std::optional<std::uint64_t> step_of(const fs::path& file) {
  const std::string name = file.filename().string();
  std::string_view rest(name);
  if (!rest.starts_with(kPrefix)) return std::nullopt;
  rest.remove_prefix(std::string_view(kPrefix).size());
  const auto digits = rest.substr(0, rest.find('.'));
  if (digits.size() < kDigits || !ends_as_written(rest.substr(digits.size()))) return std::nullopt;
  return whole(digits);
}

}  // namespace

fs::path checkpoint_manifest(const fs::path& folder, std::uint64_t step) {
  return folder / (stem_of(step) + kSuffix);
}

fs::path checkpoint_part(const fs::path& folder, std::uint64_t step, std::uint64_t rank) {
  return folder / (stem_of(step) + "." + std::to_string(rank) + ".h5");
}

fs::path manifest_of(const fs::path& file) {
  return checkpoint_manifest(file.parent_path(), step_of(file).value_or(0));
}

bool is_checkpoint_file(const fs::path& file) { return step_of(file).has_value(); }

CheckpointPart write_checkpoint_part(const fs::path& folder, const CheckpointHeader& header,
                                     std::uint64_t rank, CheckpointContent content) {
  const fs::path file = checkpoint_part(folder, header.step, rank);
  content.texts[kHeaderText] = header_of_part(header, rank);
  try {
    const FileImage image = to_hdf5(std::move(content));
    write_file_atomically(file, image.bytes());
    return {image.bytes().size(), hash_bytes(image.bytes())};
  } catch (const ImageError& error) {
    throw MachineError("cannot write '" + file.string() + "': " + error.what());
  }
}

void write_checkpoint_manifest(const fs::path& folder, const CheckpointHeader& header,
                               const std::vector<CheckpointPart>& parts) {
  write_file_atomically(checkpoint_manifest(folder, header.step), to_text({header, parts}));
}

Checkpoint read_checkpoint(const fs::path& manifest_file) {
  const auto manifest = manifest_from(read_plain(manifest_file, 1, kLargestManifest));
  if (!manifest) throw CheckpointError(manifest_file, "it is damaged or no manifest");
  if (step_of(manifest_file) != manifest->header.step) {
    throw CheckpointError(manifest_file, "its name is of another step than its content");
  }
  Checkpoint checkpoint;
  checkpoint.header = manifest->header;
  const fs::path folder = manifest_file.parent_path();
  for (std::uint64_t rank = 0; rank < manifest->header.ranks; ++rank) {
    const auto file = checkpoint_part(folder, manifest->header.step, rank);
    CheckpointContent content = read_part(file, *manifest, rank);
    if (rank == 0) checkpoint.content.texts = std::move(content.texts);
    std::move(content.tables.begin(), content.tables.end(),
              std::back_inserter(checkpoint.content.tables));
  }
  return checkpoint;
}

std::vector<fs::path> checkpoints_in(const fs::path& folder) {
  std::vector<fs::path> manifests;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == kSuffix && is_checkpoint_file(entry.path())) {
      manifests.push_back(entry.path());
    }
  }
  std::sort(manifests.begin(), manifests.end(),
            [](const fs::path& a, const fs::path& b) { return step_of(b) < step_of(a); });
  return manifests;
}

namespace {
/// Removes files of checkpoints of the steps that `goes` names, and all that was left half written.
void remove_checkpoints(const fs::path& folder, const std::function<bool(std::uint64_t)>& goes) {
  std::vector<fs::path> manifests, others;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const auto step = step_of(entry.path());
    const bool temporary = entry.path().extension().string().starts_with(".tmp-");
    std::error_code unread;
    if (!step || entry.symlink_status(unread).type() != fs::file_type::regular) continue;
    if (!temporary && !goes(*step)) continue;
    (entry.path().extension() == kSuffix ? manifests : others).push_back(entry.path());
  }
  if (error) throw MachineError("cannot read the folder '" + folder.string() + "'");
  // A manifest goes first: what is left without one is no checkpoint.
  for (const auto* files : {&manifests, &others}) {
    for (const auto& file : *files) {
      fs::remove(file, error);
      if (error) throw MachineError("cannot remove '" + file.string() + "': " + error.message());
    }
  }
}
}  // namespace

void remove_checkpoints_but(const fs::path& folder, const std::vector<std::uint64_t>& kept) {
  remove_checkpoints(folder, [&](std::uint64_t step) {
    return std::find(kept.begin(), kept.end(), step) == kept.end();
  });
}

void remove_checkpoints_after(const fs::path& manifest) {
  const std::uint64_t last = step_of(manifest).value_or(0);
  const fs::path folder = manifest.has_parent_path() ? manifest.parent_path() : fs::path(".");
  remove_checkpoints(folder, [&](std::uint64_t step) { return step > last; });
}

}  // namespace brunt
