// What names tell of a texture's material.
#include "world/material.h"

#include <gtest/gtest.h>

namespace slicecast {
namespace {

TEST(Materials, AreToldByTheFirstTellingWord) {
    EXPECT_EQ(materialOfName("wood"), Material::wood);
    EXPECT_EQ(materialOfName("../textures/planks-floor.png"), Material::wood);
    EXPECT_EQ(materialOfName("metal-rusty.png"), Material::metal);
    EXPECT_EQ(materialOfName("dark grass"), Material::grass);
    EXPECT_EQ(materialOfName("grass on stone"), Material::grass);
    EXPECT_EQ(materialOfName("stone on grass"), Material::stone);
    EXPECT_EQ(materialOfName("sea-water_2"), Material::water);
}

// Words, not letters: sandstone is no sand, and glasses are no glass.
TEST(Materials, AreNotToldByPartsOfWords) {
    for (const char* name : {"", "-", "sandstone", "glasses.png", "WOOD", "brick", "#80a060"})
        EXPECT_EQ(materialOfName(name), std::nullopt) << name;
}

}  // namespace
}  // namespace slicecast
