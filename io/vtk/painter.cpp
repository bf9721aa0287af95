#include "io/vtk/painter.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>

#include "core/errors.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/messages.hpp"
#include "io/vtk/overlay.hpp"
#include "io/vtk/picture_bytes.hpp"

namespace brunt {

namespace {

constexpr std::size_t kCellsWithEdges = 20000;
constexpr const char* kScalars = "scalars";
constexpr Colour kRigid = {214, 218, 224};
constexpr Colour kRigidLine = {120, 126, 134};
constexpr Colour kBlack = {0, 0, 0};
/// Pale colours of bodies that deform but have not the field that colours the picture.
constexpr std::array<Colour, 4> kPlain = {
    {{166, 189, 219}, {204, 187, 160}, {180, 205, 175}, {210, 180, 200}}};

vtkSmartPointer<vtkLookupTable> lookup_table(const Interval& range) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  const auto map = colour_map(is_diverging(range));
  table->SetNumberOfTableValues(static_cast<vtkIdType>(map.size()));
  for (std::size_t i = 0; i < map.size(); ++i) {
    table->SetTableValue(static_cast<vtkIdType>(i), map[i][0] / 255.0, map[i][1] / 255.0,
                         map[i][2] / 255.0);
  }
  if (!range.empty()) table->SetTableRange(range.low, range.high);
  return table;
}

bool is_solid(const BodyView& body) { return body.corners > 4 || body.cell_dimension == 3; }

/// The body's shape with nothing but the numbers that colour it.
vtkSmartPointer<vtkUnstructuredGrid> shape_of(const BodyView& body, const Scalars& scalars) {
  BodyView bare;
  bare.position = body.position;
  bare.connectivity = body.connectivity;
  bare.corners = body.corners, bare.cell_dimension = body.cell_dimension;
  if (!scalars.values.empty()) {
    (scalars.on_cells ? bare.cell_fields : bare.point_fields)
        .push_back({kScalars, 1, scalars.values});
  }
  return to_grid(bare);
}

/// The outer surface, with normals that break at edges; a flat one as it is.
vtkSmartPointer<vtkPolyData> surface_of(vtkUnstructuredGrid* grid, bool solid) {
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(grid);
  surface->Update();
  if (!solid) return surface->GetOutput();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(surface->GetOutputPort());
  normals->SetFeatureAngle(35);
  normals->ConsistencyOff();
  normals->Update();
  return normals->GetOutput();
}

vtkSmartPointer<vtkPolyDataMapper> mapper_of(const BodyView& body, const Scalars& scalars) {
  const auto grid = shape_of(body, scalars);
  if (body.corners != 0) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(surface_of(grid, is_solid(body)));
    return mapper;
  }
  auto mapper = vtkSmartPointer<vtkOpenGLSphereMapper>::New();
  vtkNew<vtkPolyData> points;
  points->SetPoints(grid->GetPoints());
  points->SetVerts(grid->GetCells());  // the mapper takes its bounds from cells
  if (auto* numbers = grid->GetPointData()->GetArray(kScalars)) {
    points->GetPointData()->AddArray(numbers);
  }
  vtkNew<vtkFloatArray> radius;  // the mapper reads floats, whatever the array holds
  radius->SetName("radius");
  for (const Real r : body.point_radius) radius->InsertNextValue(static_cast<float>(r));
  points->GetPointData()->AddArray(radius);
  mapper->SetInputData(points);
  mapper->SetScaleArray(radius->GetName());
  return mapper;
}

void set_colour(vtkProperty& property, Colour colour) {
  property.SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

/// The outline of a rigid surface: its rims and its sharp edges.
void add_outline(vtkRenderer& renderer, vtkPolyData* surface) {
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->SetFeatureAngle(35);
  edges->ManifoldEdgesOff();
  edges->NonManifoldEdgesOff();
  edges->ColoringOff();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(edges->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  set_colour(*actor->GetProperty(), kRigidLine);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(1.2 * kOversampling);
  renderer.AddActor(actor);
}

void add_body(vtkRenderer& renderer, const BodyView& body, std::size_t index,
              const PictureStyle& style, vtkLookupTable* table) {
  const bool flat = style.camera.axes.toward == Vec3::UnitZ() && !is_solid(body);
  const bool rigid = !style.all_deform && !deforms(body);
  const Scalars scalars =
      rigid || style.range.empty() ? Scalars{} : scalars_of(body, style.colouring);
  const auto mapper = mapper_of(body, scalars);
  if (scalars.values.empty()) {
    mapper->ScalarVisibilityOff();
  } else {
    if (scalars.on_cells) {
      mapper->SetScalarModeToUseCellFieldData();
    } else {
      mapper->SetScalarModeToUsePointFieldData();
      if (body.corners != 0) mapper->InterpolateScalarsBeforeMappingOn();
    }
    mapper->SelectColorArray(kScalars);
    mapper->SetLookupTable(table);
    mapper->UseLookupTableScalarRangeOn();
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  auto& property = *actor->GetProperty();
  set_colour(property, rigid ? kRigid : kPlain[index % kPlain.size()]);
  if (rigid && body.corners == 2) set_colour(property, kRigidLine);
  property.SetAmbient(flat ? 1.0 : 0.34);
  property.SetDiffuse(flat ? 0.0 : 0.78);
  property.SetSpecular(flat ? 0.0 : 0.08);
  property.SetSpecularPower(20);
  property.SetLineWidth(3 * kOversampling);
  if (!rigid && body.corners > 2 && body.n_cells() < kCellsWithEdges) {
    property.EdgeVisibilityOn();
    property.SetEdgeColor(0.30, 0.30, 0.33);
    property.SetLineWidth(0.6 * kOversampling);
  }
  renderer.AddActor(actor);
  if (rigid && body.corners > 2) add_outline(renderer, mapper->GetInput());
}

void set_camera(vtkRenderer& renderer, const PictureStyle& style) {
  const auto& camera = style.camera;
  const Vec3 focus = camera.center_right * camera.axes.right + camera.center_up * camera.axes.up;
  const Real distance = 10 * camera.pixel * style.width;
  const Vec3 eye = focus + distance * camera.axes.toward;
  auto& view = *renderer.GetActiveCamera();
  view.ParallelProjectionOn();
  view.SetFocalPoint(focus.data());
  view.SetPosition(eye.data());
  view.SetViewUp(camera.axes.up.data());
  view.SetParallelScale(0.5 * style.height * camera.pixel);
  renderer.ResetCameraClippingRange();
}

/// A key light from the upper left behind the eye and a weak one from the other side.
void add_lights(vtkRenderer& renderer) {
  renderer.RemoveAllLights();
  renderer.AutomaticLightCreationOff();
  constexpr std::array<std::array<double, 4>, 3> lights = {
      {{-0.45, 0.75, 1.0, 0.85}, {0.8, 0.1, 0.6, 0.30}, {0.0, -0.6, 0.6, 0.12}}};
  for (const auto& [x, y, z, intensity] : lights) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer.AddLight(light);
  }
}

/// Where the middles of contacts lie in a picture [pixel].
std::vector<std::array<Real, 2>> places_of(const ContactView& contacts, const PictureStyle& style) {
  const Camera& camera = style.camera;
  std::vector<std::array<Real, 2>> places;
  std::size_t first = 0;
  for (const int corners : contacts.polygon_size) {
    const auto n = slot_of(corners);
    Vec3 middle = Vec3::Zero();
    for (std::size_t k = 3 * first; k < 3 * (first + n); ++k) {
      middle[static_cast<int>(k % 3)] += contacts.position[k] / corners;
    }
    first += n;
    places.push_back(
        {(middle.dot(camera.axes.right) - camera.center_right) / camera.pixel + 0.5 * style.width,
         (middle.dot(camera.axes.up) - camera.center_up) / camera.pixel + 0.5 * style.height});
  }
  return places;
}

}  // namespace

Painter::Painter(PictureStyle style)
    : style_(std::move(style)),
      offscreen_(style_.width * kOversampling, style_.height * kOversampling) {
  offscreen_.window().SetMultiSamples(0);
}

std::string Painter::paint(const std::vector<BodyView>& bodies, Real time,
                           const ContactView& contacts) {
  VtkMessages messages;
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  const auto table = lookup_table(style_.range);
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!bodies[b].position.empty()) add_body(*renderer, bodies[b], b, style_, table);
  }
  add_lights(*renderer);
  set_camera(*renderer, style_);
  Overlay overlay(*renderer, kOversampling);
  overlay.dots(places_of(contacts, style_), 5, kBlack);
  if (!style_.range.empty()) {
    draw_scalar_bar(overlay, style_.width, style_.height, style_.colouring, style_.range);
  }
  draw_length_bar(overlay, style_.width, style_.camera.pixel);
  draw_axes(overlay, style_.camera.axes);
  draw_heading(overlay, style_.height, style_.title, time, style_.last_time);

  auto& window = offscreen_.window();
  window.AddRenderer(renderer);
  std::string bytes = picture_bytes(window, style_.width, style_.height, messages);
  window.RemoveRenderer(renderer);
  return bytes;
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
