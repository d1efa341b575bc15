// Robots' models as URDF, from robots that may be hostile.
#include "core/io/model/urdf.h"

#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/settings/folders.h"
#include "core/robot/model/model_body.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string robot(const std::string& body) {
    return "<?xml version=\"1.0\"?>\n<robot name=\"rover\">\n" + body + "</robot>\n";
}

std::string errorOf(const std::string& text) {
    const auto model = readUrdf(text, "rover");
    EXPECT_FALSE(model.ok()) << text.substr(0, 200);
    return model.ok() ? std::string() : model.error().text;
}

const std::string TwoLinks = "<link name=\"base_link\"/><link name=\"arm\"/>\n";

TEST(Urdf, LinksJointsAndShapesAreRead) {
    const auto model = readUrdf(robot(R"(
  <material name="blue"><color rgba="0 0.2 1 1"/></material>
  <link name="base_link">
    <visual><origin xyz="0.1 0 0.2" rpy="0 0 1.5"/><geometry><box size="0.4
      0.3 0.2"/></geometry><material name="blue"/></visual>
    <collision><geometry><cylinder radius="0.2" length="0.1"/></geometry></collision>
    <inertial><mass value="3"/></inertial>
  </link>
  <link name="arm"><visual><geometry><mesh filename="package://rover/arm.stl" scale="0.001 0.001 0.001"/></geometry></visual></link>
  <link name="tip"><visual><geometry><sphere radius="0.05"/></geometry></visual></link>
  <joint name="tip_joint" type="prismatic"><parent link="arm"/><child link="tip"/><mimic joint="shoulder" multiplier="2" offset="0.5"/></joint>
  <joint name="shoulder" type="revolute"><parent link="base_link"/><child link="arm"/>
    <origin xyz="0 0 0.5"/><axis xyz="0 -2 0"/><limit lower="-1" upper="2.5" effort="1" velocity="1"/></joint>
  <transmission name="t"><joint name="shoulder"/></transmission>
)"),
                                "rover");
    ASSERT_TRUE(model) << model.error().text;
    ASSERT_EQ(model->links.size(), 3U);
    EXPECT_EQ(model->root, 0U);
    const LinkPart& box = model->links[0].visuals.at(0);
    EXPECT_TRUE(std::get<BoxShape>(box.shape).size.isApprox(Eigen::Vector3d(0.4, 0.3, 0.2)));
    EXPECT_TRUE(box.partInLink.translation().isApprox(Eigen::Vector3d(0.1, 0, 0.2)));
    EXPECT_TRUE(box.colour->isApprox(PartColour(0.0F, 0.2F, 1.0F)));
    EXPECT_EQ(std::get<CylinderShape>(model->links[0].collisions.at(0).shape).radius, 0.2);
    EXPECT_EQ(std::get<MeshShape>(model->links[1].visuals.at(0).shape).uri, "package://rover/arm.stl");
    ASSERT_EQ(model->joints.size(), 2U);
    EXPECT_EQ(model->joints[0].name, "shoulder") << "nearer to the root";
    EXPECT_TRUE(model->joints[0].axis.isApprox(-Eigen::Vector3d::UnitY()));
    EXPECT_EQ(model->joints[0].upper, 2.5);
    EXPECT_EQ(model->joints[1].mimics->joint, "shoulder");
}

TEST(Urdf, MistakesAreToldWithTheirLine) {
    EXPECT_THAT(errorOf(""), HasSubstr("expected XML"));
    EXPECT_THAT(errorOf("no XML at all"), StartsWith("rover:"));
    EXPECT_THAT(errorOf("<sdf/>"), HasSubstr("expected <robot>"));
    EXPECT_THAT(errorOf(robot("")), HasSubstr("expected at least one <link>"));
    EXPECT_THAT(errorOf(robot("<link/>")), StartsWith("rover:3: expected an attribute name of <link>"));
    EXPECT_THAT(errorOf(robot("<link name=\"a\"/>\n<link name=\"a\"/>")),
                StartsWith("rover:4: expected a name of its own, found \"a\""));
    EXPECT_THAT(errorOf(robot(TwoLinks)), HasSubstr("expected one link without a parent, found 2"));
    EXPECT_THAT(errorOf(robot(TwoLinks + "<joint name=\"j\" type=\"ball\"/>")),
                HasSubstr("continuous, prismatic, floating or planar, found \"ball\""));
    EXPECT_THAT(errorOf(robot(TwoLinks + "<joint name=\"j\" type=\"fixed\"><parent link=\"base_link\"/>"
                                         "<child link=\"leg\"/></joint>")),
                StartsWith("rover:4: expected a link of the model, found \"leg\""));
    EXPECT_THAT(errorOf(robot("<link name=\"a\"><visual/></link>")), HasSubstr("expected <geometry>"));
    EXPECT_THAT(errorOf(robot("<link name=\"a\"><visual><geometry><cone/></geometry></visual></link>")),
                HasSubstr("expected box, cylinder, sphere or mesh, found cone"));
}

TEST(Urdf, NumbersThatAreNoneAreRefused) {
    for (const char* size :
         {"1 1", "1 1 1 1", "nan 1 1", "inf 1 1", "1e9 1 1", "a b c", "", "-1 1 1", "${width} 1 1"}) {
        const std::string text = "<link name=\"a\"><visual><geometry><box size=\"" + std::string(size) +
                                 "\"/></geometry></visual></link>";
        EXPECT_THAT(errorOf(robot(text)), StartsWith("rover:3: expected")) << size;
    }
    const std::string joint = TwoLinks +
                              "<joint name=\"j\" type=\"revolute\"><parent link=\"base_link\"/>"
                              "<child link=\"arm\"/><axis xyz=\"0 0 0\"/></joint>";
    EXPECT_THAT(errorOf(robot(joint)), HasSubstr("expected an axis other than 0 0 0"));
}

TEST(Urdf, WhatIsNoTreeIsRefused) {
    const auto fixed = [](const std::string& name, const std::string& parent, const std::string& child) {
        return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
               child + "\"/></joint>\n";
    };
    const std::string links = "<link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>\n";
    EXPECT_THAT(errorOf(robot(links + fixed("1", "b", "c") + fixed("2", "c", "b"))), HasSubstr("a circle"));
    EXPECT_THAT(errorOf(robot(links + fixed("1", "a", "a") + fixed("2", "a", "b") + fixed("3", "a", "c"))),
                HasSubstr("expected one link without a parent, found 0"));
    EXPECT_THAT(errorOf(robot(links + fixed("1", "a", "c") + fixed("2", "b", "c"))),
                StartsWith("rover:5: expected one parent of link \"c\""));
}

TEST(Urdf, HugeAndDeepOnesEndWithAnError) {
    std::string deep = "<robot name=\"r\">";
    for (int i = 0; i < 200'000; ++i) deep += "<a>";
    EXPECT_THAT(errorOf(deep), HasSubstr("expected XML"));
    std::string wide = "<robot name=\"r\">";
    for (int i = 0; i < 3'000; ++i) wide += "<link name=\"l" + std::to_string(i) + "\"/>";
    EXPECT_THAT(errorOf(wide + "</robot>"), HasSubstr("at most 2000 links"));
    std::string full = "<robot name=\"r\"><link name=\"l\">";
    for (int i = 0; i < 10'500; ++i) full += "<visual><geometry><sphere radius=\"1\"/></geometry></visual>";
    EXPECT_THAT(errorOf(full + "</link></robot>"), HasSubstr("at most 10000 shapes"));
    const std::string entities =
        "<!DOCTYPE r [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>"
        "<robot name=\"&b;\"><link name=\"x\"/></robot>";
    const auto read = readUrdf(entities, "rover");
    EXPECT_LE(read ? read->name.size() : 0U, 8U) << "entities are never expanded";
}

TEST(Urdf, CutOffAnywhereItEndsWithAnErrorOrAModel) {
    const std::string whole = readText(shippedFolder("stock") / "tracked.urdf");
    ASSERT_TRUE(readUrdf(whole, "tracked"));
    for (std::size_t size = 0; size < whole.size(); size += 37) (void)readUrdf(whole.substr(0, size), "cut");
    for (std::size_t at = 0; at < whole.size(); at += 53) {
        std::string broken = whole;
        broken[at] = '\xff';
        (void)readUrdf(broken, "broken");
    }
}

TEST(Urdf, ModelsOfStockRobotsAreWhole) {
    for (const char* name : {"tracked", "husky", "turtlebot4", "ouster", "livox"}) {
        const auto model = readUrdf(readText(shippedFolder("stock") / (std::string(name) + ".urdf")), name);
        ASSERT_TRUE(model) << model.error().text;
        const auto body = bodyOf(*model, "base_link",
                                 [](const std::string& uri) -> Result<TriangleMesh> { return Error{uri}; });
        const auto extent = extentOf(body);
        ASSERT_TRUE(extent) << name << ": " << extent.error().text;
        EXPECT_GT(extent->height, 0.2) << name;
        EXPECT_LT(extent->height, 0.8) << name;
    }
}

}  // namespace
}  // namespace leitstand::test
