#include <gtest/gtest.h>

#include <harmos/input/Registry.hpp>

#include "Sample.hpp"

namespace harmos::input {
namespace {

struct Shape {
  virtual ~Shape() = default;
  virtual double area() const = 0;
};

struct Square final : Shape {
  explicit Square(double s) : side(s) {}
  double area() const override { return side * side; }
  double side;
};

TEST(Registry, BuildsByTypeAndNamesTheNearest) {
  Registry<Shape> shapes;
  ParameterSpec spec("Square");
  spec.number("Side").required();
  const auto factory = [](const Parameters& p) { return std::make_unique<Square>(p.number("Side")); };
  shapes.add(spec, factory);
  Parameters p("shape");
  p.set("Type", std::string("Square")).set("Side", 3.0);
  EXPECT_EQ(shapes.create(p)->area(), 9.0);
  EXPECT_EQ(shapes.forms().size(), 1u);
  p.set("Type", std::string("square"));
  EXPECT_EQ(messageOf([&] { shapes.create(p); }),
            "shape: unknown type \"square\".\n  Did you mean \"Square\"? Allowed: Square.");
  EXPECT_EQ(messageOf([&] { shapes.add(spec, factory); }), "\"Square\" is registered already.");
}

TEST(Registry, HandsOnWhatElseIsNeededAndChecks) {
  Registry<Shape, const double&> shapes;
  ParameterSpec spec("Square");
  spec.number("Side").required();
  shapes.add(
      spec, [](const Parameters& p, const double& unit) { return std::make_unique<Square>(unit * p.number("Side")); },
      [](const Parameters& p, ErrorList& errors) {
        if (p.number("Side") > 2.0) errors.add(p.where("Side"), "too large.");
      });
  Parameters p("shape");
  p.set("Type", std::string("Square")).set("Side", 3.0);
  EXPECT_EQ(shapes.create(p, 2.0)->area(), 36.0);
  ErrorList errors;
  shapes.check(p, errors);
  EXPECT_EQ(errors.count(), 1);
}

TEST(ErrorList, CanBeNestedWithoutItsClosingLine) {
  ErrorList errors;
  errors.add("a.xml:1: A", "is wrong.", "Repair it.");
  errors.add("a.xml:2: B", "is wrong.");
  const std::string list = "a.xml:1: A: is wrong.\n  Repair it.\na.xml:2: B: is wrong.";
  try {
    errors.throwIfAny();
    FAIL();
  } catch (const InputErrors& error) {
    EXPECT_EQ(error.list(), list);
    EXPECT_EQ(error.what(), list + "\n2 errors; nothing was run.");
    EXPECT_EQ(error.what(), errors.message());
    EXPECT_EQ(error.code(), base::ExitCode::input);
  }
}

}  // namespace
}  // namespace harmos::input
