#include <filesystem>
#include <ostream>

#include <harmos/base/AllRanks.hpp>
#include <harmos/cli/detail/Verbs.hpp>
#include <harmos/files/AtomicFile.hpp>
#include <harmos/files/ExodusWriter.hpp>
#include <harmos/files/OutputGuard.hpp>
#include <harmos/scene/MeshSource.hpp>
#include <harmos/scene/Scene.hpp>

namespace harmos::cli {

namespace {

int writeMesh(const Arguments& arguments, const CommandEnvironment& environment) {
  arguments.requireOperands({"SCENE.xml"});
  const std::string& path = arguments.operands()[0];
  const scene::Scene scene = scene::readScene(path, arguments.values("--set"), laws::builtInLaws());
  const std::string file = arguments.value("--output", std::filesystem::path(path).stem().string() + "_mesh.e");
  files::demandDistinct(scene::inputFiles(scene), {file});
  base::onFirstRank(*environment.communicator, [&] { files::demandWritable({file}); });
  const mesh::Mesh mesh = scene::makeMesh(scene.input.list("Mesh"), path);
  if (!environment.isRoot()) return 0;
  files::createFolderOf(file);
  files::ExodusWriter writer(file, scene.input.text("Title"), files::resultMesh(mesh), {});
  writer.commit();
  if (!arguments.has("--quiet"))
    environment.out << file << ": " << mesh.nodes.size() << " nodes, " << writer.mesh().elements() << " elements in "
                    << mesh.blocks.size() << " blocks, " << mesh.sideSets.size() << " side sets, "
                    << mesh.nodeSets.size() << " node sets\n";
  return 0;
}

}  // namespace

Command meshCommand() {
  return {"mesh",
          "SCENE.xml",
          "Write the mesh of a scene to an Exodus file.",
          {{"--output", "FILE", "default: SCENE_mesh.e in the current folder"},
           {"--set", "'LIST/NAME=VALUE'", "replace an entry of the scene; may be repeated", true},
           {"--quiet", "", "print nothing"}},
          {"harmos mesh xml/bolted_joint.xml", "harmos mesh xml/glued_assembly.xml --output glued.e"},
          writeMesh};
}

}  // namespace harmos::cli
