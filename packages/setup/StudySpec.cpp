#include <harmos/setup/StudySpec.hpp>

namespace harmos::setup {

namespace {

void describeParameter(base::ParameterSpec& spec) {
  spec.summary(
      "What varies. The names are yours and stand in formulas and tables: letters, digits and underscores. A parameter "
      "is free, then the design chooses its values, or derived, then it has a Formula.");
  spec.text("Entry").optional().doc("Entry of the scene that it sets, as for --set: Values/mu, or List/Sublist/Name.");
  spec.texts("Entries").optional().doc("Several entries that it sets, instead of Entry.");
  spec.text("Unit").defaultValue("").doc("For tables and pictures.");
  spec.numbers("Values").optional().doc("Its levels.");
  spec.number("From").optional().doc("First of evenly spaced levels.");
  spec.number("To").optional().doc("Last of evenly spaced levels.");
  spec.integer("Count").optional().atLeast(1).doc("Number of evenly spaced levels.");
  spec.number("Lower").optional().doc("Least value, for designs that choose any value in between.");
  spec.number("Upper").optional().doc("Largest value, for designs that choose any value in between.");
  spec.text("Formula").optional().doc("Of a derived parameter, such as 2 * preload_1.");
}

base::ParameterSpec& addCount(base::ParameterSpec& spec) {
  spec.integer("Count").required().atLeast(1).doc("Number of points, those that conditions leave out included.");
  return spec;
}

std::vector<base::ParameterSpec> designForms() {
  base::ParameterSpec grid("Grid"), list("List"), random("Random"), cube("Latin Hypercube"), sobol("Sobol"),
      adaptive("Adaptive");
  grid.summary("All combinations of the levels; the last parameter varies fastest.");
  list.summary("The rows of a table.");
  list.text("File").required().doc(
      "CSV, path relative to the study's file; its header names all free parameters, in any order.");
  addCount(random.summary("Independent uniform values."));
  random.integer("Seed").defaultValue(1).doc("The same seed gives the same points everywhere.");
  addCount(cube.summary("Every parameter's range is cut into as many strata as there are points; each is hit once."));
  cube.source("McKay, Beckman, Conover, Technometrics 21 (1979)");
  cube.integer("Seed").defaultValue(1).doc("The same seed gives the same points everywhere.");
  addCount(sobol.summary("Sobol' sequence: fills the space evenly; a longer one begins with the shorter one."));
  sobol.source("Joe, Kuo, SIAM J. Sci. Comput. 30 (2008)");
  sobol.integer("Seed").defaultValue(0).doc("0: the plain sequence; else a random digital shift.");
  adaptive.summary(
      "Chooses its points itself until the surface of one response is known to a tolerance over the box of the free "
      "parameters, which may set laws and loads only.");
  adaptive.text("Response").required().doc("Name of an entry of the study's Responses.");
  adaptive.number("Tolerance")
      .unit("-")
      .defaultValue(1e-2)
      .above(0.0)
      .below(1.0)
      .doc("Largest error of the surface, at 95 % confidence, relative to the largest value of the response.");
  adaptive.integer("Initial Count")
      .defaultValue(0)
      .atLeast(0)
      .doc("Points to begin with; 0: twice as many as a quadratic polynomial has terms.");
  adaptive.integer("Maximum Count").defaultValue(200).atLeast(1).doc("Most points.");
  adaptive.integer("Seed").defaultValue(0).doc("0: plain Sobol' sequences; else with a random digital shift.");
  return {grid, list, random, cube, sobol, adaptive};
}

std::vector<base::ParameterSpec> policyForms() {
  base::ParameterSpec retry("Retry"), record("Record"), abort("Abort"), recover("Recover"), more("Continuation");
  retry.summary("Solve it again from a cold start, on its own; if that fails too, record it and go on. The default.");
  retry.integer("Count").defaultValue(1).atLeast(1).doc("How often.");
  record.summary("Record it and go on.");
  abort.summary("End the study; what is solved is kept.");
  recover.summary("Record it, put these values in place of its responses, and go on.");
  recover.numbers("Values").doc("One per response, in their order.");
  more.summary(
      "Walk to it from the nearest configuration that is solved, in steps that are halved until it is solved or they "
      "are too many.");
  more.integer("Steps").defaultValue(8).atLeast(2).doc("Most steps.");
  return {retry, record, abort, recover, more};
}

std::vector<base::ParameterSpec> functionalForms() {
  base::ParameterSpec maximum("Maximum"), minimum("Minimum"), last("Final"), magnitude("Largest Magnitude"),
      time("At Time");
  maximum.summary("Largest value over the load steps.");
  minimum.summary("Smallest value over the load steps.");
  last.summary("Value at the last load step.");
  magnitude.summary("Value of largest magnitude over the load steps, with its sign.");
  time.summary("Value at a time, linear between load steps.");
  time.number("Time").unit("time").required().atLeast(0.0).doc("When.");
  return {maximum, minimum, last, magnitude, time};
}

}  // namespace

base::ParameterSpec studySpec() {
  base::ParameterSpec spec("Harmos Study");
  spec.summary("A parametric study: a scene, what varies in it, which values, and what to report.");
  spec.text("Title").defaultValue("").doc("Of the report.");
  spec.text("Scene").required().doc("XML file of the scene, path relative to the study's file.");
  spec.texts("Scene Overrides")
      .optional()
      .doc("Changes of the scene for the whole study, each List/Sublist/Name=value as for --set, without commas.");
  spec.number("Accuracy")
      .unit("-")
      .optional()
      .atLeast(1e-10)
      .atMost(3e-2)
      .doc("Largest relative error of every curve and of the field of interface forces; absent: that of the scene.");
  describeParameter(spec.namedLists("Parameters", true));
  spec.namedLists("Conditions")
      .summary("Configurations that do not satisfy all conditions are left out and counted.")
      .text("Formula")
      .required()
      .doc("True or false, such as preload_1 >= preload_2.");
  spec.alternatives("Design", designForms()).summary("Which values the free parameters take together; absent: a grid.");
  spec.alternatives("Failure Policy", policyForms())
      .summary("What to do with a configuration that fails or does not reach the accuracy; absent: Retry.");
  spec.namedLists("Responses")
      .summary("Numbers to report per configuration, made of the histories of the scene's responses.")
      .choose(functionalForms())
      .text("Response")
      .required()
      .doc("Name of a response of the scene.");
  return spec;
}

}  // namespace harmos::setup
