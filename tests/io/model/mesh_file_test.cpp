// Meshes of robots' models, and where they are looked for.
#include "core/io/model/mesh_file.h"

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/io/model/package_files.h"
#include "tests/io/file_checks.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string Stl =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 2\n"
    "endloop\nendfacet\nendsolid s\n";

/// One triangle as Collada, in @p unit [m] and with the axis @p up.
std::string collada(const std::string& unit, const std::string& up) {
    return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter=")" +
           unit + R"("/><up_axis>)" + up + R"(</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="c"><lambert><diffuse><color>1 0.5 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 2</float_array><technique_common><accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="m" count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common><instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
)";
}

Eigen::AlignedBox3f boxOf(const TriangleMesh& mesh) {
    Eigen::AlignedBox3f box;
    for (const auto& vertex : mesh.vertices) box.extend(vertex);
    return box;
}

TEST(MeshFile, StlAndObjAreRead) {
    const TemporaryFolder folder;
    const auto stl = readMesh(written(folder / "a.STL", Stl));
    ASSERT_TRUE(stl) << stl.error().text;
    EXPECT_EQ(stl->triangles.size(), 1U);
    EXPECT_EQ(stl->colours.size(), 1U);
    EXPECT_TRUE(boxOf(*stl).max().isApprox(Eigen::Vector3f(1, 1, 2)));
    const auto obj = readMesh(written(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
    ASSERT_TRUE(obj) << obj.error().text;
    EXPECT_EQ(obj->triangles.size(), 2U) << "a side of four corners";
}

TEST(MeshFile, ColladaIsScaledToMetresInItsOwnAxes) {
    const TemporaryFolder folder;
    for (const char* up : {"Z_UP", "Y_UP"}) {
        const auto mesh = readMesh(written(folder / "a.dae", collada("0.001", up)));
        ASSERT_TRUE(mesh) << mesh.error().text;
        EXPECT_TRUE(boxOf(*mesh).max().isApprox(Eigen::Vector3f(0.001F, 0.001F, 0.002F), 1e-4F))
            << up << ": " << boxOf(*mesh).max().transpose();
        EXPECT_TRUE(mesh->colours.at(0).isApprox(PartColour(1.0F, 0.5F, 0.0F), 1e-3F))
            << mesh->colours.at(0).transpose();
    }
}

TEST(MeshFile, WhatIsNoMeshIsRefusedByName) {
    const TemporaryFolder folder;
    EXPECT_THAT(errorOf(readMesh(folder / "none.stl")), HasSubstr("none.stl: expected a file"));
    EXPECT_THAT(errorOf(readMesh(written(folder / "a.yaml", Stl))),
                HasSubstr("a.yaml: expected a mesh as dae, stl"));
    fs::create_directory(folder / "folder.stl");
    EXPECT_THAT(errorOf(readMesh(folder / "folder.stl")), HasSubstr("expected a file"));
    EXPECT_THAT(errorOf(readMesh(written(folder / "b.dae", "no XML"))), HasSubstr("b.dae: expected a mesh"));
    EXPECT_THAT(errorOf(readMesh(written(folder / "c.obj", "v 0 0 0\n"))), HasSubstr("c.obj: expected"));
    EXPECT_THAT(errorOf(readMesh(written(folder / "d.stl",
                                         "solid s\nfacet normal 0 0 1\nouter loop\nvertex "
                                         "nan 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                         "endloop\nendfacet\nendsolid s\n"))),
                HasSubstr("d.stl: expected"));
}

TEST(MeshFile, CutOffAnywhereItEndsWithAnErrorOrAMesh) {
    const TemporaryFolder folder;
    const std::string dae = collada("1", "Z_UP");
    for (std::size_t size = 0; size < dae.size(); size += 61)
        (void)readMesh(written(folder / "cut.dae", dae.substr(0, size)));
    for (std::size_t size = 0; size < Stl.size(); size += 5)
        (void)readMesh(written(folder / "cut.stl", Stl.substr(0, size)));
}

TEST(PackageFiles, AreFoundInTheFoldersOfTheRobotsFile) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "ws/rover_description/meshes");
    writeText(folder / "ws/rover_description/meshes/a.stl", Stl);
    RobotDescription robot;
    robot.file = (folder / "rover.yaml").string();
    robot.packages = {"ws"};
    const auto file = PackageFiles::of(robot).find("package://rover_description/meshes/a.stl");
    ASSERT_TRUE(file) << file.error().text;
    EXPECT_TRUE(fs::equivalent(*file, folder / "ws/rover_description/meshes/a.stl"));
    robot.packages = {"ws/rover_description"};
    EXPECT_TRUE(PackageFiles::of(robot).find("package://rover_description/meshes/a.stl"))
        << "the package itself is named";
    EXPECT_TRUE(
        PackageFiles::of(robot).find("file://" + (folder / "ws/rover_description/meshes/a.stl").string()));
    EXPECT_THAT(errorOf(PackageFiles::of(robot).find("package://other/a.stl")),
                HasSubstr("no folder of the robot's file (packages) has package other"));
}

TEST(PackageFiles, ARobotReadsNothingOutsideOfThem) {
    const TemporaryFolder folder;
    fs::create_directories(folder / "ws/rover/meshes");
    writeText(folder / "secret.stl", Stl);
    writeText(folder / "ws/near.stl", Stl);
    const PackageFiles files({folder / "ws"});
    for (const std::string& uri :
         {std::string("package://rover/../../secret.stl"), std::string("package://../secret.stl"),
          "file://" + (folder / "secret.stl").string(), (folder / "secret.stl").string(),
          std::string("../secret.stl"), std::string("file:///dev/zero"), std::string("http://a/b.stl"),
          std::string("package://"), std::string("package://rover"), std::string()})
        EXPECT_FALSE(files.find(uri)) << uri;
    EXPECT_TRUE(files.find("package://rover/../near.stl")) << "within a folder that the user named";
}

}  // namespace
}  // namespace leitstand::test
