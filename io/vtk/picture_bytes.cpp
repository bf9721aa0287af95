#include "io/vtk/picture_bytes.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include "core/errors.hpp"

namespace brunt {

namespace {
/// Averages squares of kOversampling x kOversampling pixels.
vtkSmartPointer<vtkImageData> averaged(vtkUnsignedCharArray& pixels, int width, int height) {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  const unsigned char* in = pixels.GetPointer(0);
  const std::size_t row = 3 * slot_of(width) * kOversampling;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        int sum = 0;
        for (std::size_t sy = 0; sy < kOversampling; ++sy) {
          for (std::size_t sx = 0; sx < kOversampling; ++sx) {
            const std::size_t line = slot_of(y) * kOversampling + sy;
            const std::size_t place = slot_of(x) * kOversampling + sx;
            sum += in[line * row + 3 * place + c];
          }
        }
        constexpr int n = kOversampling * kOversampling;
        *out++ = static_cast<unsigned char>((sum + n / 2) / n);
      }
    }
  }
  return image;
}

std::string png_of(vtkImageData* image) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  auto* bytes = writer->GetResult();
  return std::string(reinterpret_cast<const char*>(bytes->GetPointer(0)),
                     slot_of(bytes->GetNumberOfValues()));
}
}  // namespace

std::string picture_bytes(vtkRenderWindow& window, int width, int height,
                          const VtkMessages& messages) {
  window.Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window.GetPixelData(0, 0, width * kOversampling - 1, height * kOversampling - 1, 0, pixels);
  if (messages.any() || pixels->GetNumberOfValues() == 0) {
    throw MachineError("cannot draw a picture: " + messages.text());
  }
  return png_of(averaged(*pixels, width, height));
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
