// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/Verdict.h"

#include "Base/BettiWords.h"
#include "Base/Errors.h"

#include <utility>

namespace medial
{
namespace
{
/// A stage, with its article, and the Betti numbers of its result.
struct Topology
{
  const char* stage;
  Betti betti;
};

std::vector<std::string> differences(const Topology& before, const Topology& after)
{
  if (before.betti == after.betti)
  {
    return {};
  }
  return { text(after.stage, " has ", inWords(after.betti), ", but ", before.stage, " ",
    inWords(before.betti)) };
}

/// What contradicts that a surface has the topology of what it was made from.
std::vector<std::string> faults(const Findings& findings, const Topology& source)
{
  if (!findings.closed)
  {
    return { "the surface is not closed" };
  }
  if (!findings.manifold)
  {
    return { "the surface is not a manifold" };
  }
  return differences(source, { "the surface", findings.crust });
}

/// One reason, which names the warnings.
std::vector<std::string> doubts(const Warnings& warnings)
{
  std::string codes;
  for (const Warning& warning : warnings)
  {
    if (warning.doubtsSolid)
    {
      codes += text(codes.empty() ? "" : ", ", "'", warning.code, "'");
    }
  }
  return codes.empty() ? std::vector<std::string>()
                       : std::vector<std::string>{ "the samples may not determine the solid, see "
                                                   "what is warned of: " +
                           codes };
}

void append(const std::vector<std::string>& from, std::vector<std::string>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}
}

Verdict verdict(const Findings& findings)
{
  const Topology powerShape{ "the power shape", findings.powerShape };
  std::vector<std::string> against;
  std::vector<std::string> allowed;
  if (findings.solid)
  {
    append(differences({ "the solid given", *findings.solid }, powerShape), against);
  }
  if (findings.axis)
  {
    const Topology axis{ "the axis", findings.axis->unpruned };
    const Topology pruned{ "the pruned axis", findings.axis->pruned };
    append(differences(powerShape, axis), against);
    append(differences(axis, pruned), findings.axis->topologyKept ? against : allowed);
    append(faults(findings, pruned), against);
  }
  else
  {
    against.emplace_back(
      "the surface was made of all inner balls, without an axis, so pruning had no "
      "effect on it: connect the pruned axis to the second input");
    append(faults(findings, powerShape), against);
  }
  append(doubts(findings.warnings), against);
  Verdict result{ against.empty(), std::move(against) };
  for (const std::string& difference : allowed)
  {
    result.reasons.push_back(difference + "; pruning was allowed to change it");
  }
  return result;
}

const char* nameOf(const Verdict& verdict)
{
  return verdict.certified ? "certified" : "not certified";
}

std::string sentenceOf(const Verdict& verdict)
{
  std::string result = text("The surface is ", nameOf(verdict));
  for (const std::string& reason : verdict.reasons)
  {
    result += (&reason == &verdict.reasons.front() ? ": " : "; ") + reason;
  }
  return result;
}
}
