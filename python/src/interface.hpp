// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <microslip_ellipse.h>

#include <cstddef>

/// \file
/// The Python package calls these functions for scenes, which microslip.h has not. The interface is
/// private: it changes with the package, which loads no other library than its own.

extern "C" {

/// Where a scene comes from. Texts are UTF-8.
struct microslip_py_scene {
  const char* text;
  const char* name;                ///< of the text, for messages
  const char* folder;              ///< to which its file names refer, with '/' at its end, or empty
  const char* const* assignments;  ///< "key=value" over the text; of no value: without that key
  std::size_t assignment_count;
  const char* const* file_names;  ///< of files that are in memory
  const char* const* file_texts;
  std::size_t file_count;
};

/// Called now and then; work ends if it answers other than 0.
typedef int (*microslip_py_progress)(std::size_t done, std::size_t total);

/// microslip_status, and one more.
enum { MICROSLIP_PY_STOPPED = 5 };

// These describe the last failed call of this thread, which answered null or a status.
MICROSLIP_API int microslip_py_error_status(void);
MICROSLIP_API const char* microslip_py_error_key(void);  ///< empty if it is about none
MICROSLIP_API const char* microslip_py_error_message(void);

/// A line a key of scenes: name, type, unit, meaning, what is accepted, default and role, with
/// tabs.
MICROSLIP_API const char* microslip_py_keys(void);

/// Scenes that have been read: one, or all cases of one with a sweep. They are solved, or they are
/// ellipses or other patches of which curves are wanted.
/// With is_swept, curves are those of a sweep only if the scene has one.
struct microslip_py_cases;
MICROSLIP_API microslip_py_cases* microslip_py_read(const microslip_py_scene* scene, int is_swept,
                                                    int is_curve);
MICROSLIP_API void microslip_py_cases_destroy(microslip_py_cases* cases);
/// The swept keys, and their values in each case: rows that end with the control character RS, of
/// cells that end with US.
MICROSLIP_API const char* microslip_py_swept(const microslip_py_cases* cases);
/// Doubts about values, a line each, as they are told before a case is solved.
MICROSLIP_API const char* microslip_py_warnings(const microslip_py_cases* cases, std::size_t at);

/// Tables of a solution. Cases may be solved in several threads at once, one in each.
struct microslip_py_tables;
MICROSLIP_API microslip_py_tables* microslip_py_solve(const microslip_py_cases* cases,
                                                      std::size_t at,
                                                      microslip_py_progress progress);
MICROSLIP_API void microslip_py_tables_destroy(microslip_py_tables* tables);
MICROSLIP_API std::size_t microslip_py_table_count(const microslip_py_tables* tables);
MICROSLIP_API const char* microslip_py_table_name(const microslip_py_tables* tables,
                                                  std::size_t table);
/// As the program writes it.
MICROSLIP_API const char* microslip_py_table_text(const microslip_py_tables* tables,
                                                  std::size_t table);

/// The contact of a scene, to roll: for the functions of microslip.h. What the scene says about its
/// problem, load, steps, start and motion is left out.
MICROSLIP_API microslip_rolling* microslip_py_rolling(const microslip_py_scene* scene);
/// As microslip_save() and microslip_restore(), without a file.
/// \return a text that is valid until this thread's next call; null if it fails
MICROSLIP_API const char* microslip_py_save(microslip_rolling* rolling);
MICROSLIP_API int microslip_py_restore(microslip_rolling* rolling, const char* text);
/// \param factors  out: of the half-width and of the bound, as they are set
MICROSLIP_API int microslip_py_contact(const microslip_rolling* rolling, double* factors);
/// The file that a writer of a path replaces.
/// \return a path that is valid until this thread's next call; null for what is no regular file
MICROSLIP_API const char* microslip_py_writable_target(const char* path);

/// Steady rolling of the contact of a scene, by the method of that if its problem is steady.
struct microslip_py_steady;
MICROSLIP_API microslip_py_steady* microslip_py_steady_read(const microslip_py_scene* scene);
MICROSLIP_API void microslip_py_steady_destroy(microslip_py_steady* steady);
MICROSLIP_API std::size_t microslip_py_steady_size(const microslip_py_steady* steady);
MICROSLIP_API double microslip_py_full_sliding(const microslip_py_steady* steady);
/// FASTSIM's force of each creepage in the same contact, see curve.beside.
/// \param slope   |dF/dw| at w = 0  [N/mm]
/// \param forces  out
MICROSLIP_API int microslip_py_fastsim(const microslip_py_steady* steady, double slope,
                                       const double* creepages, std::size_t count, double* forces);
MICROSLIP_API const char* microslip_py_steady_warnings(const microslip_py_steady* steady);

/// Why the largest of the loads is doubtful; empty if it is not. Valid until the next call.
MICROSLIP_API const char* microslip_py_steady_doubt(const microslip_py_steady* steady,
                                                    int load_type, const double* loads,
                                                    std::size_t count);
/// As microslip_solve_steady(), on several threads.
/// \param messages  `count` rows of `room` bytes: why a load has no solution
MICROSLIP_API int microslip_py_steady_solve(const microslip_py_steady* steady, int load_type,
                                            const double* loads, std::size_t count, int threads,
                                            microslip_steady* states,
                                            const microslip_steady_nodes* nodes, char* messages,
                                            std::size_t room);

/// Whether the contact of a scene has three dimensions: 1 or 0, and -1 if the call fails.
MICROSLIP_API int microslip_py_has_patch(const microslip_py_scene* scene);

/// The contact patch of a scene, an ellipse or another one. What the scene says about its problem,
/// load, steps, start and motion is left out.
struct microslip_py_patch;
MICROSLIP_API microslip_py_patch* microslip_py_patch_read(const microslip_py_scene* scene);
MICROSLIP_API void microslip_py_patch_destroy(microslip_py_patch* patch);
MICROSLIP_API const char* microslip_py_patch_warnings(const microslip_py_patch* patch);
MICROSLIP_API std::size_t microslip_py_patch_rows(const microslip_py_patch* patch);
MICROSLIP_API std::size_t microslip_py_patch_elements(const microslip_py_patch* patch);
MICROSLIP_API double microslip_py_patch_full_sliding(const microslip_py_patch* patch);
/// The table of the edges, as the program writes it. Valid until this thread's next call; null if
/// it fails.
MICROSLIP_API const char* microslip_py_patch_edges(const microslip_py_patch* patch);
/// Why a motion is doubtful; empty if it is not. Valid until this thread's next call.
/// \param component  0, 1 or 2: along, across or spin
MICROSLIP_API const char* microslip_py_patch_doubt(const microslip_py_patch* patch, int component,
                                                   double motion);
/// The same of an ellipse by numbers.
/// \param size    (a b)^(1/2)  [mm]
/// \param strain  the mean of the traction bound over the shear modulus
MICROSLIP_API const char* microslip_py_motion_doubt(int component, double motion, double size,
                                                    double strain);
/// Why the units of a shear modulus, or of the largest traction beside it, are doubtful; empty if they
/// are not. Valid until this thread's next call.
MICROSLIP_API const char* microslip_py_units_doubt(double shear_modulus, double traction);
/// To roll: for the functions of microslip_ellipse.h.
MICROSLIP_API microslip_ellipse* microslip_py_patch_ellipse(const microslip_py_patch* patch);

/// The factors of the size and of the bound that are set.
/// \param factors  out, both
MICROSLIP_API int microslip_py_ellipse_contact(const microslip_ellipse* ellipse, double* factors);

/// Steady rolling under many loads, each on its own. Values of a load without solution are not
/// numbers.
struct microslip_py_patch_solutions {
  microslip_ellipse_state* states;  ///< `count` of them
  double* changes;                  ///< of the result from rows and elements that are a third fewer
  int* statuses;                    ///< of microslip_status
  char* messages;                   ///< `count` rows of `room` bytes
  std::size_t room;
  microslip_ellipse_cells cells;  ///< `count` rows of all elements in each array
};
MICROSLIP_API int microslip_py_patch_steady(microslip_py_patch* patch,
                                            const microslip_ellipse_load* loads, std::size_t count,
                                            int threads,
                                            const microslip_py_patch_solutions* solutions);
}
