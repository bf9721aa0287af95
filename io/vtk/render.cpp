#include "io/vtk/render.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/run_files.hpp"
#include "io/vtk/frame_reader.hpp"
#include "io/vtk/overlay.hpp"
#include "io/vtk/painter.hpp"

namespace brunt {

namespace {

[[noreturn]] void fail(const std::string& option, const std::string& message) {
  std::vector<DeckProblem> problems(1);
  problems[0].place.file = "render";
  problems[0].path = option;
  problems[0].message = message;
  throw DeckError(std::move(problems));
}

std::size_t frame_number(std::string_view text, std::size_t count) {
  std::size_t number = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || number >= count) {
    fail("frames", "expects all, last or numbers from 0 to " + std::to_string(count - 1) +
                       ", got '" + std::string(text) + "'");
  }
  return number;
}

std::vector<std::size_t> chosen_frames(const std::string& text, std::size_t count) {
  if (count == 0) fail("frames", "there is no frame to draw");
  if (text == "last") return {count - 1};
  std::vector<std::size_t> numbers;
  if (text == "all") {
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(i);
    return numbers;
  }
  std::string_view rest = text;
  while (true) {
    const auto comma = rest.find(',');
    numbers.push_back(frame_number(rest.substr(0, comma), count));
    if (comma == std::string_view::npos) return numbers;
    rest.remove_prefix(comma + 1);
  }
}

/// What one pass over the frames finds out.
struct Survey {
  std::vector<Colouring> candidates;
  std::vector<Interval> ranges;  ///< of each candidate
  std::set<std::string> fields;  ///< that deforming bodies have
};

/// True where no body has a field that tells those that deform: frames of `fields: [temperature]`.
bool tell_nothing(const std::vector<BodyView>& bodies) {
  return std::none_of(bodies.begin(), bodies.end(), deforms);
}

void take(Survey& survey, const BodyView& body, bool all_deform) {
  if (!all_deform && !deforms(body)) return;
  for (const auto* fields : {&body.point_fields, &body.cell_fields}) {
    for (const auto& field : *fields) survey.fields.insert(field.name);
  }
  for (std::size_t c = 0; c < survey.candidates.size(); ++c) {
    for (const Real value : scalars_of(body, survey.candidates[c]).values) {
      survey.ranges[c].take(value);
    }
  }
}

std::vector<Colouring> candidates(const std::string& field) {
  if (!field.empty()) return {parse_colouring(field)};
  return {{"eps_p", ""}, {"von_mises", ""}, {"velocity", "magnitude"}};
}

/// Index of the candidate to colour by, or nothing where no body has any.
std::optional<std::size_t> choose(const Survey& survey) {
  for (std::size_t c = 0; c < survey.candidates.size(); ++c) {
    const bool flows = survey.ranges[c].high > 0;
    if (survey.candidates[c].field == "eps_p" && survey.candidates.size() > 1 && !flows) continue;
    if (!survey.ranges[c].empty()) return c;
  }
  return std::nullopt;
}

PictureStyle style_of(const FrameSource& source, const std::vector<std::size_t>& frames,
                      const RenderOptions& options) {
  PictureStyle style;
  style.width = options.width;
  style.height = options.height;
  style.title = options.title;
  style.last_time = source.times.back();
  const auto axes = view_axes(options.view, is_flat(source.bodies(frames.front())));
  Coverage coverage(axes);
  Survey survey{candidates(options.field), {}, {}};
  survey.ranges.resize(survey.candidates.size());
  style.all_deform = !options.field.empty() && tell_nothing(source.bodies(frames.front()));
  for (const std::size_t frame : frames) {
    for (const auto& body : source.bodies(frame)) {
      coverage.take(body);
      take(survey, body, style.all_deform);
    }
  }
  const auto chosen = choose(survey);
  if (!chosen && !options.field.empty()) {
    std::string message = "no deforming body has the field '" + options.field + "'; there are:";
    for (const auto& name : survey.fields) message.append(" ").append(name);
    fail("field", message);
  }
  if (chosen) {
    style.colouring = survey.candidates[*chosen];
    style.range = colour_range(survey.ranges[*chosen], shows_from_zero(style.colouring.field));
  }
  if (options.range) style.range = {options.range->first, options.range->second};
  style.camera = fit(axes, coverage.frame(), options.width, options.height, overlay_margins());
  return style;
}

std::filesystem::path picture_path(const std::filesystem::path& out, const Colouring& colouring,
                                   std::size_t frame) {
  std::array<char, 24> number;
  std::snprintf(number.data(), number.size(), ".%05zu.png", frame);
  const std::string name = colouring.field.empty() ? "frame" : colouring.name();
  return out / (name + number.data());
}

}  // namespace

std::vector<std::filesystem::path> render_frames(const FrameSource& source,
                                                 const std::filesystem::path& out,
                                                 const RenderOptions& options) {
  if (options.width < 400 || options.height < 300 || options.width > 8000 ||
      options.height > 8000) {
    fail("size", "expects from 400 x 300 to 8000 x 8000 pixels");
  }
  if (options.range && !(options.range->first < options.range->second)) {
    fail("range", "expects a lower and a higher number");
  }
  const auto frames = chosen_frames(options.frames, source.times.size());
  std::vector<std::filesystem::path> paths;
  try {
    const PictureStyle style = style_of(source, frames, options);
    Painter painter(style);
    create_folder(out);
    for (const std::size_t frame : frames) {
      paths.push_back(picture_path(out, style.colouring, frame));
      list_files(out, {paths.back().filename().string()});
      const bool dots = options.contacts && source.contacts;
      replace_file(paths.back(), painter.paint(source.bodies(frame), source.times[frame],
                                               dots ? source.contacts(frame) : ContactView{}));
    }
  } catch (const std::invalid_argument& error) {
    fail(options.field, error.what());
  }
  return paths;
}

std::vector<std::filesystem::path> render_folder(const std::filesystem::path& folder,
                                                 const std::filesystem::path& out,
                                                 const RenderOptions& options) {
  const auto index = read_frame_index(folder);
  FrameSource source;
  for (const auto& frame : index) source.times.push_back(frame.time);
  source.bodies = [&](std::size_t frame) { return read_frame(folder, index[frame]); };
  source.contacts = [&](std::size_t frame) { return read_contacts(folder, index[frame]); };
  return render_frames(source, out, options);
}

}  // namespace brunt
