#include "MesoHeightLevelsTexture.h"

#include "MesoHeightPyramid.h"
#include "MesoLevelLayout.h"
#include "MesoMapUpload.h"
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
  const MesoLevelLayout layout{ std::size_t(size[0]), std::size_t(size[1]), this->Levels.size() };
  std::vector<float> texels(layout.GetTexels(), 0.f);
  for (std::size_t number = 0; number < this->Levels.size(); ++number)
  {
    int extent[3];
    this->Levels[number]->GetDimensions(extent);
    auto* from = static_cast<const float*>(
      this->Levels[number]->GetPointData()->GetScalars()->GetVoidPointer(0));
    float* to = texels.data() + layout.FirstOf(number);
    for (int row = 0; row < extent[1]; ++row, from += extent[0], to += layout.GetWidth())
    {
      std::copy(from, from + extent[0], to);
    }
  }
  if (!MesoUploadTexels(this->Texture(), window, layout.GetWidth(), layout.GetHeight(), 1,
        VTK_FLOAT, texels.data()))
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
