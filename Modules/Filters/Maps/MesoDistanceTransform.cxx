#include "MesoDistanceTransform.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>

namespace
{
using Vector = MesoVolumeField::Vector;

Vector operator-(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

Vector operator+(const Vector& a, const Vector& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

Vector operator*(double s, const Vector& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}

double Dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
}

MesoDistanceTransform::MesoDistanceTransform(const MesoVolumeField& field)
  : Field(field)
  , Voxel(1. / std::max(field.GetSize()[0], field.GetSize()[1]))
  , Surface(this->FindSurface())
{
}

// Moves a position in tile widths onto the surface; false where it does not come there.
bool MesoDistanceTransform::Project(Vector& position) const
{
  const double depth = this->Field.GetDepth();
  constexpr int Steps = 8;
  constexpr double Close = 1e-4; // of a voxel
  for (int step = 0; step < Steps; ++step)
  {
    const Vector place = { position[0], position[1], position[2] / depth };
    const Vector gradient = this->Field.Gradient(place);
    const double square = Dot(gradient, gradient);
    if (!(square > 0.))
    {
      return false;
    }
    const double value = this->Field.At(place);
    double part = value / square;
    const double length = std::abs(value) / std::sqrt(square);
    if (length > this->Voxel)
    {
      part *= this->Voxel / length;
    }
    position = position - part * gradient;
    position[2] = std::clamp(position[2], 0., depth);
    if (length < Close * this->Voxel)
    {
      return true;
    }
  }
  return false;
}

std::vector<MesoDistanceTransform::Vector> MesoDistanceTransform::FindSurface() const
{
  const auto& size = this->Field.GetSize();
  const Vector spacing = { 1. / size[0], 1. / size[1], this->Field.GetDepth() / size[2] };
  std::vector<std::vector<Vector>> slices(size[2]);
  const auto findSlice = [&](int k)
  {
    std::vector<Vector>& found = slices[k];
    const int top = std::min(k + 1, size[2] - 1);
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const Vector low = { (i + 0.5) * spacing[0], (j + 0.5) * spacing[1],
          (k + 0.5) * spacing[2] };
        const double here = this->Field.Sample(i, j, k);
        int inside = 0;
        for (int c = 0; c < 8; ++c)
        {
          inside += this->Field.Sample(i + (c & 1), j + ((c >> 1) & 1), (c >> 2) ? top : k) < 0.;
        }
        if (inside == 0 || inside == 8)
        {
          continue;
        }
        const double next[3] = { this->Field.Sample(i + 1, j, k), this->Field.Sample(i, j + 1, k),
          this->Field.Sample(i, j, top) };
        for (int axis = 0; axis < 3; ++axis)
        {
          if ((here < 0.) != (next[axis] < 0.))
          {
            Vector crossing = low;
            crossing[axis] += spacing[axis] * here / (here - next[axis]);
            found.push_back(crossing);
          }
        }
        for (int c = 0; c < 8; ++c)
        {
          Vector start = low;
          for (int axis = 0; axis < 3; ++axis)
          {
            start[axis] += spacing[axis] * (((c >> axis) & 1) ? 0.75 : 0.25);
          }
          Vector moved = start;
          if (this->Project(moved))
          {
            found.push_back(moved);
          }
        }
      }
    }
  };
  vtkSMPTools::For(0, size[2],
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType k = first; k < last; ++k)
      {
        findSlice(static_cast<int>(k));
      }
    });
  std::vector<Vector> points;
  for (const auto& slice : slices)
  {
    for (const Vector& point : slice)
    {
      for (int tile = 0; tile < 9; ++tile)
      {
        const int column = tile % 3 - 1;
        const int row = tile / 3 - 1;
        const double x = point[0] + column;
        const double y = point[1] + row;
        if (std::abs(x - 0.5) <= 1. && std::abs(y - 0.5) <= 1.)
        {
          points.push_back({ x, y, point[2] });
        }
      }
    }
  }
  return points;
}

// Of a position in tile widths; `nearest` is a guess, and then the nearest point's number.
double MesoDistanceTransform::DistanceOf(const Vector& position, std::size_t& nearest) const
{
  const double depth = this->Field.GetDepth();
  if (this->Surface.Empty())
  {
    return 1. + depth;
  }
  nearest = this->Surface.Nearest(position, nearest);
  Vector foot = this->Surface[nearest];
  double square = Dot(position - foot, position - foot);
  constexpr int Slides = 4;
  for (int slide = 0; slide < Slides; ++slide)
  {
    const Vector gradient = this->Field.Gradient({ foot[0], foot[1], foot[2] / depth });
    const Vector away = position - foot;
    Vector along =
      away - (Dot(away, gradient) / std::max(Dot(gradient, gradient), 1e-300)) * gradient;
    const double length = std::sqrt(Dot(along, along));
    Vector moved = foot + std::min(1., this->Voxel / std::max(length, 1e-300)) * along;
    if (!this->Project(moved))
    {
      break;
    }
    const double movedSquare = Dot(position - moved, position - moved);
    if (!(movedSquare < square))
    {
      break;
    }
    square = movedSquare;
    foot = moved;
  }
  return std::sqrt(square);
}

void MesoDistanceTransform::Slices(int first, int last, float* distances) const
{
  const auto& size = this->Field.GetSize();
  vtkSMPTools::For(0, vtkIdType(last - first) * size[1],
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType row = begin; row < end; ++row)
      {
        const int k = first + static_cast<int>(row / size[1]);
        const int j = static_cast<int>(row % size[1]);
        std::size_t nearest = 0;
        for (int i = 0; i < size[0]; ++i)
        {
          const double distance = this->DistanceOf({ (i + 0.5) / size[0], (j + 0.5) / size[1],
                                                     (k + 0.5) / size[2] * this->Field.GetDepth() },
            nearest);
          distances[row * size[0] + i] =
            static_cast<float>(this->Field.Sample(i, j, k) < 0. ? -distance : distance);
        }
      }
    });
}

vtkSmartPointer<vtkImageData> MesoCanonicalVolume(
  const MesoVolumeField& field, vtkAlgorithm* filter)
{
  constexpr int SlicesAtOnce = 4; // between two reports of progress
  const auto& size = field.GetSize();
  const MesoDistanceTransform transform(field);
  const std::size_t slice = std::size_t(size[0]) * std::size_t(size[1]);
  std::vector<float> distances(slice * std::size_t(size[2]));
  for (int first = 0; first < size[2]; first += SlicesAtOnce)
  {
    if (filter->GetAbortExecute())
    {
      return nullptr;
    }
    const int last = std::min(first + SlicesAtOnce, size[2]);
    transform.Slices(first, last, distances.data() + first * slice);
    filter->UpdateProgress(static_cast<double>(last) / size[2]);
  }
  return MesoMakeVolume(size, field.GetDepth(), distances);
}
