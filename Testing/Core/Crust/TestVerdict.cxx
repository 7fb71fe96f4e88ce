// SPDX-License-Identifier: BSD-3-Clause
#include "Crust/Verdict.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace
{
using medial::Findings;
using medial::Verdict;

/// A torus for which all stages agree.
Findings agreeing()
{
  Findings result;
  result.powerShape = result.crust = { 1, 1, 0 };
  result.axis = { { 1, 1, 0 }, { 1, 1, 0 }, true };
  result.closed = result.manifold = true;
  return result;
}

medial::Warning warning(const char* code, bool doubtsSolid)
{
  return { code, "It is so.", 3, {}, doubtsSolid };
}

TEST(Verdict, CertifiesWhatAgrees)
{
  Findings findings = agreeing();
  EXPECT_TRUE(medial::verdict(findings).certified);
  EXPECT_TRUE(medial::verdict(findings).reasons.empty());
  EXPECT_STREQ(medial::nameOf(medial::verdict(findings)), "certified");
  findings.solid = medial::Betti{ 1, 1, 0 };
  EXPECT_TRUE(medial::verdict(findings).certified);
}

/// A change that takes the certificate away, and the one reason that must be given.
struct Fault
{
  std::function<void(Findings&)> make;
  std::string reason;
};

TEST(Verdict, RefusesEachFaultWithItsReason)
{
  const Fault faults[] = {
    { [](Findings& f) {
       f.powerShape = { 2, 1, 0 };
     },
      "the axis has 1 piece, 1 tunnel, 0 voids, but the power shape 2 pieces, 1 tunnel, 0 voids" },
    { [](Findings& f) {
       f.axis->unpruned = f.axis->pruned = f.crust = { 1, 2, 0 };
     },
      "the axis has 1 piece, 2 tunnels, 0 voids, but the power shape 1 piece, 1 tunnel, 0 voids" },
    { [](Findings& f) {
       f.axis->pruned = f.crust = { 1, 0, 0 };
     },
      "the pruned axis has 1 piece, 0 tunnels, 0 voids, but the axis 1 piece, 1 tunnel, 0 voids" },
    { [](Findings& f) {
       f.crust = { 1, 1, 1 };
     },
      "the surface has 1 piece, 1 tunnel, 1 void, but the pruned axis 1 piece, 1 tunnel, 0 voids" },
    { [](Findings& f) { f.closed = f.manifold = false; }, "the surface is not closed" },
    { [](Findings& f) { f.manifold = false; }, "the surface is not a manifold" },
    { [](Findings& f) { f.warnings = { warning("noise", true) }; },
      "the samples may not determine the solid, see what is warned of: 'noise'" },
    { [](Findings& f) { f.axis.reset(); },
      "the surface was made of all inner balls, without an axis, so pruning had no effect on it: "
      "connect the pruned axis to the second input" },
    { [](Findings& f) {
       f.solid = medial::Betti{ 1, 0, 0 };
     },
      "the power shape has 1 piece, 1 tunnel, 0 voids, but the solid given 1 piece, 0 tunnels, 0 "
      "voids" },
  };
  for (const Fault& fault : faults)
  {
    Findings findings = agreeing();
    fault.make(findings);
    const Verdict verdict = medial::verdict(findings);
    EXPECT_FALSE(verdict.certified) << fault.reason;
    EXPECT_STREQ(medial::nameOf(verdict), "not certified");
    EXPECT_EQ(verdict.reasons, std::vector<std::string>{ fault.reason });
  }
}

TEST(Verdict, TellsEveryReason)
{
  Findings findings = agreeing();
  findings.axis->unpruned = { 1, 3, 0 };
  findings.closed = findings.manifold = false;
  findings.warnings = { warning("noise", true), warning("open_surface", false),
    warning("outliers", true) };
  const Verdict verdict = medial::verdict(findings);
  EXPECT_FALSE(verdict.certified);
  ASSERT_EQ(verdict.reasons.size(), 4);
  EXPECT_EQ(verdict.reasons.back(),
    "the samples may not determine the solid, see what is warned of: 'noise', 'outliers'");
}

TEST(Verdict, DoesNotCompareTheNumbersOfASurfaceThatEnclosesNothing)
{
  Findings findings = agreeing();
  findings.crust = { 0, 0, 0 };
  findings.closed = findings.manifold = false;
  EXPECT_EQ(medial::verdict(findings).reasons.size(), 1);
}

TEST(Verdict, AllowsPruningToChangeTheTopologyWhereTheUserDoes)
{
  Findings findings = agreeing();
  findings.axis = { { 1, 1, 0 }, { 1, 0, 0 }, false };
  findings.crust = { 1, 0, 0 };
  Verdict verdict = medial::verdict(findings);
  EXPECT_TRUE(verdict.certified);
  ASSERT_EQ(verdict.reasons.size(), 1);
  EXPECT_NE(verdict.reasons[0].find("allowed to change"), std::string::npos);
  findings.crust = { 1, 1, 0 }; // the crust must be that of the pruned axis all the same
  verdict = medial::verdict(findings);
  EXPECT_FALSE(verdict.certified);
  EXPECT_EQ(verdict.reasons.size(), 2);
}

TEST(Verdict, SuffersWarningsThatDoNotDoubtTheSolid)
{
  Findings findings = agreeing();
  findings.warnings = { warning("fallback", false), warning("open_surface", false) };
  EXPECT_TRUE(medial::verdict(findings).certified);
}
}
