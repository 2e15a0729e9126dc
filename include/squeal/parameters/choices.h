// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_choices_h
#define squeal_parameters_choices_h

#include <squeal/parameters/parameters.h>

#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** The values of an enumeration with the names that parameter files use. */
  template <typename Enum>
  using Choices = std::vector<std::pair<std::string, Enum>>;

  /** @name The choices of each enumeration; the argument only selects it. */
  //@{
  Choices<Parameters::Analysis>          choices(Parameters::Analysis);
  Choices<SceneParameters::Kind>         choices(SceneParameters::Kind);
  Choices<BodyParameters::Shape>         choices(BodyParameters::Shape);
  Choices<BodyParameters::MaterialModel> choices(BodyParameters::MaterialModel);
  Choices<BodyParameters::ModulusExtrapolation> choices(
    BodyParameters::ModulusExtrapolation);
  Choices<TieParameters::Kind>            choices(TieParameters::Kind);
  Choices<SpringParameters::Kind>         choices(SpringParameters::Kind);
  Choices<SupportParameters::Kind>        choices(SupportParameters::Kind);
  Choices<ContactParameters::Formulation> choices(
    ContactParameters::Formulation);
  Choices<ContactParameters::SpringLayout> choices(
    ContactParameters::SpringLayout);
  Choices<ContactParameters::FrictionLaw> choices(
    ContactParameters::FrictionLaw);
  Choices<PreloadParameters::RunIn> choices(PreloadParameters::RunIn);
  Choices<ContactParameters::State> choices(ContactParameters::State);
  Choices<ContactParameters::FrictionDirection> choices(
    ContactParameters::FrictionDirection);
  Choices<DampingParameters::Model>     choices(DampingParameters::Model);
  Choices<MatrixPartParameters::Role>   choices(MatrixPartParameters::Role);
  Choices<MatrixPartParameters::Format> choices(MatrixPartParameters::Format);
  Choices<DiscretizationParameters::Refinement> choices(
    DiscretizationParameters::Refinement);
  Choices<DiscretizationParameters::Mass> choices(
    DiscretizationParameters::Mass);
  Choices<EigenParameters::Solver>       choices(EigenParameters::Solver);
  Choices<EigenParameters::LinearSolver> choices(EigenParameters::LinearSolver);
  Choices<SweepAxisParameters::Scale>    choices(SweepAxisParameters::Scale);
  Choices<SweepAxisParameters::ShownAs>  choices(SweepAxisParameters::ShownAs);
  Choices<SweepAxisParameters::Distribution> choices(
    SweepAxisParameters::Distribution);
  Choices<WorkPrecisionParameters::Ladder> choices(
    WorkPrecisionParameters::Ladder);
  Choices<WorkPrecisionParameters::Problem> choices(
    WorkPrecisionParameters::Problem);
  Choices<TransientParameters::Start>      choices(TransientParameters::Start);
  Choices<TransientParameters::Integrator> choices(
    TransientParameters::Integrator);
  Choices<TransientParameters::ContactMethod> choices(
    TransientParameters::ContactMethod);
  Choices<TransientParameters::DiscFrame> choices(
    TransientParameters::DiscFrame);
  Choices<FrequencyResponseParameters::Quantity> choices(
    FrequencyResponseParameters::Quantity);
  Choices<FrequencyResponseParameters::Residual> choices(
    FrequencyResponseParameters::Residual);
  Choices<FrequencyResponseParameters::Scale> choices(
    FrequencyResponseParameters::Scale);
  Choices<UpdatingParameters::Pairing> choices(UpdatingParameters::Pairing);
  Choices<OutputParameters::Shapes>    choices(OutputParameters::Shapes);
  //@}

  /** The name of @p value in parameter files. */
  template <typename Enum>
  std::string
  choice_name(const Enum value)
  {
    for (const auto &choice : choices(value))
      if (choice.second == value)
        return choice.first;
    return "";
  }
} // namespace squeal

#endif
