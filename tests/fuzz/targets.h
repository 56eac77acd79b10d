#pragma once
/// Readers of foreign bytes, as functions that libFuzzer and the replay of stored inputs call.
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace nilas::fuzz {

/// Reads the bytes as one kind of input. It returns where they are accepted or refused as wrong input or as a file that
/// cannot be read. Every other exception passes, and is a finding.
using Target = void (*)(std::string_view bytes);

struct NamedTarget {
  const char* name;
  Target run;
};

void scene(std::string_view bytes);          ///< the text of a scene
void overrides(std::string_view bytes);      ///< lines of --set for one scene
void mooring(std::string_view bytes);        ///< the file of <mooring file="...">
void moordyn(std::string_view bytes);        ///< an input of MoorDyn
void tables(std::string_view bytes);         ///< tables in CSV: a user's and a run's
void ship(std::string_view bytes);           ///< the file of a ship; its first byte chooses model and propulsion
void hull(std::string_view bytes);           ///< one STL as a hull
void mesh_obj(std::string_view bytes);       ///< a mesh
void mesh_off(std::string_view bytes);       ///< a mesh
void mesh_ply(std::string_view bytes);       ///< a mesh
void mesh_stl(std::string_view bytes);       ///< a mesh
void field(std::string_view bytes);          ///< an ice field in GeoJSON
void outlines(std::string_view bytes);       ///< a library of outlines
void fclib(std::string_view bytes);          ///< a contact problem in HDF5
void checkpoint(std::string_view bytes);     ///< a state in HDF5
void bem_hdf5(std::string_view bytes);       ///< a database of BEMIO or Capytaine in HDF5
void bem_netcdf(std::string_view bytes);     ///< a database of Capytaine in classic NetCDF
void bem_wamit(std::string_view bytes);      ///< WAMIT's files, each after a line such as "== .1"
void replay(std::string_view bytes);         ///< replay.bin
void control_lines(std::string_view bytes);  ///< lines of a controller outside
void json_results(std::string_view bytes);   ///< the JSON of a run and of a hull
void live_requests(std::string_view bytes);  ///< bytes that a client sends to the live view; TOKEN stands for its token

/// All of them.
inline constexpr NamedTarget k_targets[] = {{"scene", scene},
                                            {"overrides", overrides},
                                            {"mooring", mooring},
                                            {"moordyn", moordyn},
                                            {"tables", tables},
                                            {"ship", ship},
                                            {"hull", hull},
                                            {"mesh_obj", mesh_obj},
                                            {"mesh_off", mesh_off},
                                            {"mesh_ply", mesh_ply},
                                            {"mesh_stl", mesh_stl},
                                            {"field", field},
                                            {"outlines", outlines},
                                            {"fclib", fclib},
                                            {"checkpoint", checkpoint},
                                            {"bem_hdf5", bem_hdf5},
                                            {"bem_netcdf", bem_netcdf},
                                            {"bem_wamit", bem_wamit},
                                            {"replay", replay},
                                            {"control_lines", control_lines},
                                            {"json_results", json_results},
                                            {"live_requests", live_requests}};

/// Calls a reader and takes a refusal of wrong input for an answer.
template <class Call>
void read_or_refuse(const Call& call) {
  try {
    call();
  } catch (const InputError&) {
  } catch (const FileError&) {
  } catch (const SceneError&) {
  }
}

/// A file of this name with these bytes, in a folder of this process that is removed at its end.
std::filesystem::path file_with(const std::string& name, std::string_view bytes);

}  // namespace nilas::fuzz
