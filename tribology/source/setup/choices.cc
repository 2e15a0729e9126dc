// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/setup/tribology_parameters.h>

namespace squeal::tribology
{
  Choices<TribologyParameters::Analysis>
  choices(const TribologyParameters::Analysis)
  {
    using A = TribologyParameters::Analysis;
    return {{"damage", A::damage},
            {"segmentation", A::segmentation},
            {"correlation", A::correlation},
            {"synthetic specimen", A::synthetic_specimen},
            {"recorded history", A::recorded_history}};
  }



  Choices<RecordedHistoryParameters::Source>
  choices(const RecordedHistoryParameters::Source)
  {
    using S = RecordedHistoryParameters::Source;
    return {{"clipped sine", S::clipped_sine}, {"csv", S::csv}};
  }



  Choices<RecordedHistoryParameters::Run>
  choices(const RecordedHistoryParameters::Run)
  {
    using R = RecordedHistoryParameters::Run;
    return {{"squealing", R::squealing}, {"silent", R::silent}};
  }



  Choices<FatigueParameters::Residue>
  choices(const FatigueParameters::Residue)
  {
    using R = FatigueParameters::Residue;
    return {{"half cycles", R::half_cycles}, {"repeating", R::repeating}};
  }



  Choices<FatigueParameters::Quantity>
  choices(const FatigueParameters::Quantity)
  {
    using Q = FatigueParameters::Quantity;
    return {{"pressure", Q::pressure},
            {"traction x", Q::traction_x},
            {"traction y", Q::traction_y}};
  }



  Choices<FatigueParameters::Model>
  choices(const FatigueParameters::Model)
  {
    using M = FatigueParameters::Model;
    return {{"basquin", M::basquin}, {"bilinear", M::bilinear}};
  }



  Choices<FatigueParameters::MeanStress>
  choices(const FatigueParameters::MeanStress)
  {
    using M = FatigueParameters::MeanStress;
    return {{"none", M::none},
            {"goodman", M::goodman},
            {"gerber", M::gerber},
            {"morrow", M::morrow},
            {"swt", M::swt},
            {"walker", M::walker}};
  }



  Choices<FatigueParameters::Accumulation>
  choices(const FatigueParameters::Accumulation)
  {
    using A = FatigueParameters::Accumulation;
    return {{"miner", A::miner}, {"manson halford", A::manson_halford}};
  }



  Choices<SubsurfaceParameters::Criterion>
  choices(const SubsurfaceParameters::Criterion)
  {
    using C = SubsurfaceParameters::Criterion;
    return {{"dang van", C::dang_van},
            {"crossland", C::crossland},
            {"findley", C::findley},
            {"sines", C::sines},
            {"swt", C::swt},
            {"fatemi socie", C::fatemi_socie},
            {"rankine", C::rankine},
            {"drucker prager", C::drucker_prager}};
  }



  Choices<SharedCause>
  choices(const SharedCause)
  {
    return {{"position", SharedCause::position},
            {"rim", SharedCause::rim},
            {"edges", SharedCause::edges}};
  }



  Choices<LeadingEdge>
  choices(const LeadingEdge)
  {
    return {{"automatic", LeadingEdge::automatic},
            {"lowest y", LeadingEdge::lowest_y},
            {"highest y", LeadingEdge::highest_y},
            {"lowest x", LeadingEdge::lowest_x},
            {"highest x", LeadingEdge::highest_x}};
  }



  Choices<SharedPattern>
  choices(const SharedPattern)
  {
    return {{"none", SharedPattern::none},
            {"trend", SharedPattern::trend},
            {"rim", SharedPattern::rim},
            {"leading edge", SharedPattern::leading_edge},
            {"mask", SharedPattern::mask},
            {"streaks", SharedPattern::streaks}};
  }
} // namespace squeal::tribology
