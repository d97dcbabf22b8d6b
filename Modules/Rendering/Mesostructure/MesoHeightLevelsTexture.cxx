#include "MesoHeightLevelsTexture.h"

#include "MesoHeightPyramid.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkTextureObject.h"

#include <algorithm>

MesoHeightLevelsTexture::MesoHeightLevelsTexture()
  : MesoMapTexture(1)
{
}

void MesoHeightLevelsTexture::Prepare(vtkImageData* heights)
{
  auto* values = vtkFloatArray::SafeDownCast(heights->GetPointData()->GetScalars());
  if (!values || values->GetNumberOfComponents() != 1)
  {
    this->Levels = { heights }; // the map's own texture says what is wrong
    return;
  }
  if (this->GetImage() == heights && this->PreparedTime == heights->GetMTime())
  {
    return;
  }
  int size[3];
  heights->GetDimensions(size);
  this->Levels = { heights };
  for (const MesoHeightLevel& level :
    MesoMakeHeightPyramid(size[0], size[1], values->GetPointer(0)))
  {
    vtkNew<vtkFloatArray> copy;
    copy->SetNumberOfValues(vtkIdType(level.Heights.size()));
    std::copy(level.Heights.begin(), level.Heights.end(), copy->GetPointer(0));
    vtkNew<vtkImageData> image;
    image->SetDimensions(level.Width, level.Height, 1);
    image->GetPointData()->SetScalars(copy);
    this->Levels.emplace_back(image);
  }
  this->SetImage(heights);
  this->PreparedTime = heights->GetMTime();
}

std::string MesoHeightLevelsTexture::Upload(vtkOpenGLRenderWindow* window, MesoWrap)
{
  int size[3];
  this->GetImage()->GetDimensions(size);
  const std::size_t width = std::size_t(size[0]);
  const std::size_t rows = std::size_t(size[1]);
  const std::size_t height = this->Levels.size() > 1 ? rows + rows / 2 : rows;
  std::vector<float> texels(width * height, 0.f);
  for (std::size_t number = 0; number < this->Levels.size(); ++number)
  {
    int extent[3];
    this->Levels[number]->GetDimensions(extent);
    auto* from = static_cast<const float*>(
      this->Levels[number]->GetPointData()->GetScalars()->GetVoidPointer(0));
    float* to = texels.data() + (number == 0 ? 0 : rows * width + width - ((2 * width) >> number));
    for (int row = 0; row < extent[1]; ++row, from += extent[0], to += width)
    {
      std::copy(from, from + extent[0], to);
    }
  }
  vtkTextureObject* texture = this->Texture();
  texture->ReleaseGraphicsResources(window);
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  if (!texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
        1, VTK_FLOAT, texels.data()))
  {
    return "the levels of the height map could not be made a texture";
  }
  this->Bytes = texels.size() * sizeof(float);
  return {};
}

void MesoHeightLevelsTexture::SetUniforms(vtkShaderProgram* program)
{
  this->SetSampler(program, "mesoHeightLevels");
}
