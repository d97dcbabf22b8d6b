#ifndef MarchedSheet_h
#define MarchedSheet_h

/**
 * @file MarchedSheet.h
 * @brief One displaced triangle, and the hits of rays on it by brute force.
 *
 * Written apart from the solver: a point is brought to (weights of two corners, distance along the
 * normal) by Newton's method in three unknowns; a ray is followed in small steps, and where it
 * goes from above the sheet to below, it has hit a front side. For sheets thinner than the radius of
 * curvature.
 */

#include "ReferenceWorld.h"

class MarchedSheet
{
public:
  std::array<glm::dvec3, 3> Positions;
  std::array<glm::dvec3, 3> Normals;
  std::array<glm::dvec2, 3> Coordinates; ///< of the map
  MesoHeightTexture<double> Texture;
  double Scale;

  /// Weights of the second and third corner, and the distance along the unit normal.
  struct Place
  {
    double Second = 1. / 3.;
    double Third = 1. / 3.;
    double G = 0.;

    bool Inside(double margin) const
    {
      return this->Second >= margin && this->Third >= margin &&
        this->Second + this->Third <= 1. - margin;
    }
  };

  template <typename Vector>
  static Vector Mix(const std::array<Vector, 3>& corners, const Place& at)
  {
    return corners[0] + at.Second * (corners[1] - corners[0]) +
      at.Third * (corners[2] - corners[0]);
  }

  glm::dvec3 PointAt(const Place& at) const
  {
    return Mix(this->Positions, at) + at.G * glm::normalize(Mix(this->Normals, at));
  }

  /// Where the sheet lies at these weights.
  double SheetAt(const Place& at) const
  {
    return (this->Texture.sampleHeight(Mix(this->Coordinates, at)) - 1.) * this->Scale;
  }

  /// Find a point's place from one near by; false where that does not succeed.
  bool Find(const glm::dvec3& point, Place& at) const
  {
    for (int step = 0; step < 20; ++step)
    {
      const glm::dvec3 m = Mix(this->Normals, at);
      const double length = glm::length(m);
      const glm::dvec3 n = m / length;
      const auto along = [&](int k)
      {
        const glm::dvec3 bend = this->Normals[k] - this->Normals[0];
        return this->Positions[k] - this->Positions[0] +
          (at.G / length) * (bend - n * glm::dot(n, bend));
      };
      const glm::dvec3 off = point - this->PointAt(at);
      const glm::dvec3 change = glm::inverse(glm::dmat3(along(1), along(2), n)) * off;
      at.Second += change.x;
      at.Third += change.y;
      at.G += change.z;
      if (glm::length(change) < 1e-13)
      {
        return true;
      }
    }
    return false;
  }

  /// The first hit with a front side between two t: NaN without one. Ends within the sheet's edge
  /// by `margin` (weights) do not count.
  double FirstHit(const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end,
    int steps, double margin) const
  {
    Place last;
    bool lastAbove = false;
    double lastT = begin;
    for (int step = 0; step <= steps; ++step)
    {
      const double t = begin + (end - begin) * step / steps;
      Place at = last;
      const bool known = this->Find(origin + t * direction, at) && at.Inside(margin) &&
        std::abs(at.G) < 3. * this->Scale;
      const bool above = known && at.G > this->SheetAt(at);
      if (known && lastAbove && !above)
      {
        return this->Refined(origin, direction, lastT, t, last);
      }
      lastAbove = above;
      lastT = t;
      last = known ? at : Place();
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

private:
  double Refined(const glm::dvec3& origin, const glm::dvec3& direction, double above, double below,
    Place at) const
  {
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (above + below);
      this->Find(origin + middle * direction, at);
      (at.G > this->SheetAt(at) ? above : below) = middle;
    }
    return 0.5 * (above + below);
  }
};

#endif
