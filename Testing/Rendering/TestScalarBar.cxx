// The scalar bar of a scene: colours and numbers are those that the mapper draws by, in heights or in
// the map's own numbers.

#include "MesoTestScene.h"

#include "MesoSceneBuilder.h"

#include "vtkActor2DCollection.h"
#include "vtkLookupTable.h"
#include "vtkMesoPolyDataMapper.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"

#include <gtest/gtest.h>

namespace
{
class ScalarBar : public testing::Test
{
protected:
  MesoTestScene Scene{ 60, 60 };
  MesoSceneBuilder Builder;

  /// The bars of a scene of nodes with these materials and maps.
  std::vector<vtkScalarBarActor*> Build(const std::vector<std::array<std::string, 2>>& nodes,
    const std::string& background = "[0, 0, 0]")
  {
    std::string list;
    for (const auto& node : nodes)
    {
      list += (list.empty() ? "" : ", ") + std::string(R"({"mesh": {"shape": "plane"},
        "material": {)") +
        node[0] + R"(}, "mesostructure": {"technique": "relief", "scale": 0.1, )" + node[1] + "}}";
    }
    this->Scene.Renderer->RemoveAllViewProps();
    this->Builder.Build(
      MesoParseScene(R"({"meso": 1, "background": )" + background + R"(, "nodes": [)" + list + "]}",
        "test.json"),
      this->Scene.Renderer);
    std::vector<vtkScalarBarActor*> bars;
    vtkActor2DCollection* actors = this->Scene.Renderer->GetActors2D();
    actors->InitTraversal();
    while (vtkActor2D* actor = actors->GetNextActor2D())
    {
      bars.push_back(vtkScalarBarActor::SafeDownCast(actor));
    }
    return bars;
  }

  static vtkLookupTable* TableOf(vtkScalarBarActor* bar)
  {
    return vtkLookupTable::SafeDownCast(bar->GetLookupTable());
  }
};

const char* const Heights = R"("height_map": {"pattern": "noise", "size": [16, 16]},
  "range": [-1, 3])";
const char* const Depths = R"("depth_map": {"pattern": "noise", "size": [16, 16]},
  "range": [-1, 3])";
}

TEST_F(ScalarBar, IsThereWhereItIsAskedFor)
{
  EXPECT_TRUE(this->Build({ { R"("color_by": "height")", Heights } }).empty());
  EXPECT_TRUE(this->Build({ { R"("color_by": "height", "scalar_bar": false)", Heights } }).empty());
  const auto bars = this->Build({ { R"("color_by": "height", "scalar_bar": true)", Heights } });
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_STREQ(bars[0]->GetTitle(), "height");
  EXPECT_EQ(bars[0]->GetLookupTable(), this->Builder.GetObjects()[0].Mapper->GetHeightColors());
}

TEST_F(ScalarBar, OfAnArrayIsThatOfItsColors)
{
  const auto bars = this->Build({ { R"("color_by": "TextureCoordinates[1]",
    "lookup_table": {"range": [0.25, 4]}, "scalar_bar": {"units": "m"})",
    Heights } });
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_STREQ(bars[0]->GetTitle(), "TextureCoordinates[1] [m]");
  EXPECT_EQ(bars[0]->GetLookupTable(), this->Builder.GetObjects()[0].Mapper->GetLookupTable());
  EXPECT_EQ(TableOf(bars[0])->GetRange()[1], 4.);
}

TEST_F(ScalarBar, CountsTheMapsNumbers)
{
  const std::string material = R"("color_by": "height", "lookup_table": {"range": [0.25, 1]},
    "scalar_bar": {"title": "level", "values_of": "map"})";
  for (const char* map : { Heights, Depths })
  {
    const auto bars = this->Build({ { material, map } });
    ASSERT_EQ(bars.size(), 1u);
    EXPECT_STREQ(bars[0]->GetTitle(), "level");
    vtkLookupTable* drawn = this->Builder.GetObjects()[0].Mapper->GetHeightColors();
    vtkLookupTable* shown = TableOf(bars[0]);
    ASSERT_NE(shown, drawn);
    const bool depth = map == Depths;
    EXPECT_NEAR(shown->GetRange()[0], depth ? -1. : 0., 1e-12);
    EXPECT_NEAR(shown->GetRange()[1], depth ? 2. : 3., 1e-12);
    for (const double height : { 0.31, 0.5, 0.93 })
    {
      const double number = depth ? 3. - 4. * height : -1. + 4. * height;
      std::array<double, 3> expected;
      std::array<double, 3> color;
      drawn->GetColor(height, expected.data());
      shown->GetColor(number, color.data());
      // The number may fall into the next of 256 colours.
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_NEAR(color[k], expected[k], 0.02) << height;
      }
    }
  }
}

TEST_F(ScalarBar, SeveralStandBesideOneAnotherAndAreReadable)
{
  const std::string material = R"("color_by": "height", "scalar_bar": true)";
  auto bars = this->Build({ { material, Heights }, { material, Depths } });
  ASSERT_EQ(bars.size(), 2u);
  EXPECT_LE(bars[1]->GetPosition()[0] + bars[1]->GetWidth(), bars[0]->GetPosition()[0] + 1e-9);
  EXPECT_EQ(bars[0]->GetLabelTextProperty()->GetColor()[0], 1.) << "white on black";
  bars = this->Build({ { material, Heights } }, "[0.9, 0.9, 0.6]");
  EXPECT_EQ(bars.at(0)->GetLabelTextProperty()->GetColor()[0], 0.) << "black on yellow";
}
