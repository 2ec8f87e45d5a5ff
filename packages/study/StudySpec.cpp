#include <harmos/study/StudySpec.hpp>

#include <harmos/design/Configuration.hpp>
#include <harmos/parametric/CalibratedSchedule.hpp>
#include <harmos/study/detail/DesignRegistry.hpp>
#include <harmos/study/detail/DistributionSpec.hpp>

namespace harmos::study {

namespace {

// All of them are held in memory, for every response.
constexpr int mostSamples = 1000000;

void describeParameter(input::ParameterSpec& spec) {
  spec.summary(
      "What varies. The names are yours and stand in formulas and tables: letters, digits and underscores. A parameter "
      "is free, then the design chooses its values; random, then it has a Distribution; or derived, then it has a "
      "Formula.");
  spec.text("Entry").optional().doc("Entry of the scene that it sets, as for --set: Values/mu, or List/Sublist/Name.");
  spec.texts("Entries").optional().doc("Several entries that it sets, instead of Entry.");
  spec.text("Unit").defaultValue("").doc("For tables and pictures.");
  spec.numbers("Values").optional().doc("Its levels.");
  spec.number("From").optional().doc("First of evenly spaced levels.");
  spec.number("To").optional().doc("Last of evenly spaced levels.");
  spec.integer("Count").optional().atLeast(1).atMost(design::mostConfigurations).doc("Number of evenly spaced levels.");
  spec.number("Lower").optional().doc("Least value, for designs that choose any value in between.");
  spec.number("Upper").optional().doc("Largest value, for designs that choose any value in between.");
  spec.text("Formula").optional().doc("Of a derived parameter, such as 2 * preload_1.");
  spec.alternatives("Distribution", distributionForms()).summary("Of a random parameter.");
}

std::vector<input::ParameterSpec> policyForms() {
  input::ParameterSpec retry("Retry"), record("Record"), abort("Abort"), recover("Recover"), more("Continuation");
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

std::vector<input::ParameterSpec> functionalForms() {
  input::ParameterSpec maximum("Maximum"), minimum("Minimum"), last("Final"), magnitude("Largest Magnitude"),
      time("At Time");
  maximum.summary("Largest value over the load steps.");
  minimum.summary("Smallest value over the load steps.");
  last.summary("Value at the last load step.");
  magnitude.summary("Value of largest magnitude over the load steps, with its sign.");
  time.summary("Value at a time, linear between load steps.");
  time.number("Time").unit("time").required().atLeast(0.0).doc("When.");
  return {maximum, minimum, last, magnitude, time};
}

void describeRandomness(input::ParameterSpec& spec) {
  input::ParameterSpec& correlation = spec.namedLists("Correlations");
  correlation.summary("Pairs of random parameters that depend on each other (Gaussian copula).");
  correlation.texts("Parameters").required().doc("Names of two random parameters.");
  correlation.number("Coefficient")
      .unit("-")
      .required()
      .above(-1.0)
      .below(1.0)
      .doc("Correlation of the standard Gaussian variables behind them; of normal parameters it is their own.");
  input::ParameterSpec& sweep = spec.namedLists("Sweep");
  sweep.summary(
      "Coefficients of variation that are varied over all combinations, each started from the one before; Chaos only.");
  sweep.text("Parameter").required().doc("Name of a random parameter of which mean and spread are given.");
  sweep.numbers("Values").required().doc("Its coefficients of variation.");
  input::ParameterSpec& statistics = spec.list("Statistics");
  statistics.summary("What is computed from expansions and samples.");
  statistics.numbers("Quantiles")
      .optional()
      .above(0.0)
      .below(1.0)
      .doc("Probabilities; absent: 0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99.");
  statistics.integer("Samples")
      .defaultValue(20000)
      .atLeast(100)
      .atMost(mostSamples)
      .doc("Points at which expansions are sampled for densities and quantiles; nothing is solved there.");
  statistics.integer("Seed").defaultValue(2).doc("Of these points.");
}

}  // namespace

input::ParameterSpec studySpec() {
  input::ParameterSpec spec("Harmos Study");
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
  spec.integer("Side by Side")
      .defaultValue(parametric::CalibratedSchedule::usualWidest)
      .atLeast(1)
      .atMost(64)
      .doc(
          "Configurations that march side by side at most, where ten or more are asked for: what they wait for is "
          "solved together. As many as an eighth of those that are solved; none of them starts from the others.");
  describeParameter(spec.namedLists("Parameters", true));
  spec.namedLists("Conditions")
      .summary("Configurations that do not satisfy all conditions are left out and counted.")
      .text("Formula")
      .required()
      .doc("True or false, such as preload_1 >= preload_2.");
  spec.alternatives("Design", builtInDesigns().forms())
      .summary("Which values the free parameters take together; absent: a grid.");
  describeRandomness(spec);
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

}  // namespace harmos::study
