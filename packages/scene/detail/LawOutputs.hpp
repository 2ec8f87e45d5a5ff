#pragma once

#include <string>
#include <vector>

#include <harmos/laws/InterfaceLaw.hpp>

namespace harmos::scene {

/// Names of the variables that the file of interfaces has whatever their laws, in its order.
std::vector<std::string> interfaceVariables(int dimension);

/// The numbers that laws add to the results of interfaces: one variable for all laws that give it the same name.
class LawOutputs {
 public:
  /// Where in fields() the outputs of this law are. Throws base::Error (input) when a name is that of another variable,
  /// or given to numbers of another unit by a law before.
  std::vector<std::size_t> add(const laws::InterfaceLaw& law);
  /// Of all laws so far, each once.
  const std::vector<laws::OutputField>& fields() const { return fields_; }
  /// A line for each: "name [unit]: doc".
  std::string legend() const;

 private:
  std::vector<laws::OutputField> fields_;
};

}  // namespace harmos::scene
