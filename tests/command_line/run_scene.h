// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_command_line_run_scene_h
#define voussoir_tests_command_line_run_scene_h

#include "run_program.h"
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

/** Runs one scene with other arguments each time. */
struct SceneRunner
{
  /** @param scene the text of scene.prm, written anew for each run. */
  explicit SceneRunner(const char *scene) : scene(scene) {}

  /** @return the status; what went wrong is shown, unless it is not to be. */
  int operator()(std::vector<std::string> arguments,
                 const bool shows_errors = true)
  {
    std::ofstream("scene.prm") << scene;
    arguments.insert(arguments.begin(), "scene.prm");
    const Ended ended = run_program(arguments);
    last_output = ended.out;
    if (shows_errors)
      std::cout << ended.message();
    return ended.status;
  }

  const char *const scene;
  /** What the last run printed. */
  std::string last_output;
};

#endif
