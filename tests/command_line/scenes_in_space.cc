// SPDX-License-Identifier: LGPL-2.1-or-later

// The scenes of prm/space/ as they are, each with its answer: closed forms,
// figures of the literature, and for the others those that independent code
// agrees with (contrib/judge). Their files say what carries the loads, how
// exactly, and between which proofs the factor is.

#include <nlohmann/json.hpp>

#include "own_directory.h"
#include "run_program.h"
#include "tests.h"
#include <cmath>
#include <filesystem>
#include <set>

namespace test_scenes_in_space
{
using namespace Voussoir;
namespace fs = std::filesystem;

const fs::path scenes = SOURCE_DIR "/../../prm/space";
std::set<std::string> asked;

/** Run a scene with other settings. */
Ended run_scene(const std::string &name, const std::string &setting)
{
  asked.insert(name);
  std::cout << name << (setting.empty() ? "" : ", " + setting) << std::endl;
  std::vector<std::string> words = {(scenes / (name + ".prm")).string(),
                                    "--set", "Output directory=output", "--set",
                                    "Output/Report=false"};
  if (!setting.empty())
    words.insert(words.end(), {"--set", setting});
  return run_program(words);
}

nlohmann::json summary()
{
  return nlohmann::json::parse(content_of("output/summary.json"));
}

void check_forces(const nlohmann::json &found)
{
  const nlohmann::json &proof = found["certificate"];
  check_error("  balance",
              std::max(proof["equilibrium_residual"].get<double>(),
                       proof["moment_residual"].get<double>()),
              1e-10);
  check("  limits", proof["admissibility_violation"].get<double>() <= 1e-12 &&
                        proof["max_utilisation"].get<double>() <= 1. + 1e-12);
}

/** A factor between its proofs, and a figure that is known to so many digits.*/
void check_factor(const std::string &name,
                  const double known,
                  const double digits = 1e-9,
                  const std::string &setting = "")
{
  const Ended ended = run_scene(name, setting);
  check("  is carried", ended.status == 0);
  if (ended.status != 0)
    return;
  const nlohmann::json found = summary();
  check_forces(found);
  const double carried = found["load_factor"]["carried"].get<double>(),
               bound = found["load_factor"]["bound"].get<double>();
  check_error("  width of the proofs", std::abs(bound - carried) / bound, 1e-8);
  check("  the factor", carried - digits <= known && known <= bound + digits);
}

void closed_forms()
{
  const double degree = std::acos(-1.) / 180.;
  check_factor("incline",
               0.6 * std::cos(20. * degree) - std::sin(20. * degree));
  check_factor("groove", 0.5 / std::sqrt(0.5 - 0.5 * 0.5 * 0.5));
  // The angle has six digits.
  check_factor("rock_wedge", 0.9 / std::tan(31.0743 * degree), 3e-6);
  check_factor("ferris_tin_loi_1", 0.642859003);
  check_factor("ferris_tin_loi_1", 4. / 21., 1e-9,
               "Live loads/Body force=0; 10; 0");
  check_factor("ferris_tin_loi_1", 0.269374012, 1e-9,
               "Live loads/Body force=10 * sqrt(0.5); 10 * sqrt(0.5); 0");
  check_factor("ferris_tin_loi_2", 0.579998611);
  check_factor("ferris_tin_loi_2", 4. / 35., 1e-9,
               "Live loads/Body force=0; 10; 0");
  check_factor("facade", 0.39976387, 1e-8);
}

void states()
{
  for (const std::string name : {"arch", "grains"})
  {
    check("  is carried", run_scene(name, "").status == 0);
    check_forces(summary());
  }
  const Ended falls = run_scene("arch", "Packing/vault/Thickness=0.1074");
  check("  falls", falls.status == 3);
  check("  whatever the strength",
        falls.error.find("no strength dissipates") != std::string::npos);
  check("  in a mechanism",
        summary()["mechanism"]["closing_violation"].get<double>() <= 1e-10);
  check("  is carried", run_scene("stairs", "").status == 0);
  check("  and any crowd", summary()["load_factor"]["unbounded"].get<bool>());
  check_forces(summary());
}

void run()
{
  work_in_own_directory();
  closed_forms();
  states();
  check_factor("barrel_vault", 0.28635681393);
  check_factor("building", 0.4515550433);
  check_factor("columns", 0.18200572717);
  check_factor("cross_vault", 0.4420076017);
  check_factor("dome", 0.6583548785);
  check_factor("wall", 0.5828240635);

  std::string missing;
  for (const auto &file : fs::directory_iterator(scenes))
    if (file.path().extension() == ".prm" &&
        asked.count(file.path().stem().string()) == 0)
      missing += ' ' + file.path().stem().string();
  check("each scene of prm/space/ has an answer" + missing, missing.empty());
}

const RoomTest test("scenes_in_space", run);
} // namespace test_scenes_in_space
