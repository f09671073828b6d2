#pragma once

#include <vector>

namespace touchstone {

/** How deep a pair of bodies may be at each sample of a motion, by what has happened to
 the pair so far.

 A contact is found at the latest at the end of the step in which the bodies reach each
 other. So an *arrival* at the speed V drives them up to the depth V h into each other,
 and an engine need not undo that. It must not let them go deeper afterwards. The grant of
 an arrival lasts for two steps, and at least to the next sample. Then the least depth
 since is the measure, and only a load may add to it. An engine that stops a fast body at
 the surface and lets it sink thereby has no tolerance for the speed at which the body
 once arrived, however many slow arrivals follow. */
class AllowedDepth {
 public:
  /** @param h The step. [s]
   @param by_load The depth that loads may add at any time. [m]
   @param creep The speed that a solver may leave from loads alone. [m/s] */
  AllowedDepth(double h, double by_load, double creep)
      : h_(h), by_load_(by_load), creep_(creep) {}

  /** The bodies are `depth` deep in each other at the start. [m] */
  void Begin(double depth);

  /** The bodies are apart. */
  void Part();

  /** The bodies, or bodies that touch them, have arrived at each other by `time` [s].
   That explains `depth` [m], and the solver may leave `creep` [m/s] of the speed. */
  void Arrive(double time, double depth, double creep);

  /** Returns the depth that is allowed at `time` [s], and takes account of the `depth`
   that the pair has. @pre No call had a later time. [m] */
  double Next(double time, double depth);

  /** Returns whether only the depth since earlier arrivals counts. */
  bool IsSettled() const { return arrivals_.empty(); }

  /** Returns the least depth since an arrival that explains more; 0 if none. [m] */
  double kept() const { return kept_; }

 private:
  struct Arrival {
    double time;        ///< [s]
    double depth;       ///< That it explains. [m]
    int samples_after;  ///< Number of samples since.
  };

  /** Removes the arrivals that are over at `time` [s]. */
  void EndArrivals(double time);

  /** Returns the depth that is allowed without an arrival. [m] */
  double Later(double time) const;

  double h_;
  double by_load_;
  double creep_;
  bool is_apart_ = true;
  double together_since_ = 0;      ///< The first arrival since they were apart. [s]
  double fastest_creep_ = 0;       ///< Of all arrivals since then. [m/s]
  std::vector<Arrival> arrivals_;  ///< That are not over.
  double last_depth_ = 0;          ///< At the last sample. [m]
  double kept_ = 0;
};

}  // namespace touchstone
