// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/choices.h>

namespace squeal
{
  Choices<Parameters::Analysis>
  choices(const Parameters::Analysis)
  {
    using A = Parameters::Analysis;
    return {{"modes", A::modes},
            {"cea", A::cea},
            {"sweep", A::sweep},
            {"preload", A::preload},
            {"transient", A::transient},
            {"work precision", A::work_precision},
            {"frequency response", A::frequency_response},
            {"updating", A::updating},
            {"angles", A::angles},
            {"limit cycle", A::limit_cycle},
            {"operating matrix", A::operating_matrix},
            {"triggers", A::triggers}};
  }



  Choices<SceneParameters::Kind>
  choices(const SceneParameters::Kind)
  {
    using K = SceneParameters::Kind;
    return {{"bodies", K::bodies}, {"matrices", K::matrices}};
  }



  Choices<BodyParameters::Shape>
  choices(const BodyParameters::Shape)
  {
    using S = BodyParameters::Shape;
    return {{"annulus", S::annulus},
            {"block", S::block},
            {"cylinder", S::cylinder},
            {"gmsh", S::gmsh},
            {"abaqus", S::abaqus},
            {"nastran", S::nastran},
            {"layer", S::layer},
            {"rigid", S::rigid}};
  }



  Choices<BodyParameters::MaterialModel>
  choices(const BodyParameters::MaterialModel)
  {
    using M = BodyParameters::MaterialModel;
    return {{"isotropic", M::isotropic}, {"orthotropic", M::orthotropic}};
  }



  Choices<BodyParameters::ModulusExtrapolation>
  choices(const BodyParameters::ModulusExtrapolation)
  {
    using E = BodyParameters::ModulusExtrapolation;
    return {{"refused", E::refused}, {"constant", E::constant}};
  }



  Choices<TieParameters::Kind>
  choices(const TieParameters::Kind)
  {
    using K = TieParameters::Kind;
    return {{"automatic", K::automatic},
            {"conforming", K::conforming},
            {"mortar", K::mortar}};
  }



  Choices<SpringParameters::Kind>
  choices(const SpringParameters::Kind)
  {
    using K = SpringParameters::Kind;
    return {{"points", K::points}, {"area", K::area}};
  }



  Choices<SupportParameters::Kind>
  choices(const SupportParameters::Kind)
  {
    using K = SupportParameters::Kind;
    return {{"clamped", K::clamped},
            {"components", K::components},
            {"guided", K::guided},
            {"held", K::held},
            {"free", K::free}};
  }



  Choices<ContactParameters::Formulation>
  choices(const ContactParameters::Formulation)
  {
    using F = ContactParameters::Formulation;
    return {{"springs", F::springs},
            {"mortar", F::mortar},
            {"node to surface", F::node_to_surface}};
  }



  Choices<ContactParameters::FrictionLaw>
  choices(const ContactParameters::FrictionLaw)
  {
    using L = ContactParameters::FrictionLaw;
    return {{"constant", L::constant},
            {"exponential", L::exponential},
            {"table", L::table}};
  }



  Choices<PreloadParameters::RunIn>
  choices(const PreloadParameters::RunIn)
  {
    using R = PreloadParameters::RunIn;
    return {{"none", R::none}, {"archard", R::archard}};
  }



  Choices<ContactParameters::SpringLayout>
  choices(const ContactParameters::SpringLayout)
  {
    using L = ContactParameters::SpringLayout;
    return {{"grid", L::grid}, {"quadrature", L::quadrature}};
  }



  Choices<ContactParameters::State>
  choices(const ContactParameters::State)
  {
    using S = ContactParameters::State;
    return {{"full", S::full}, {"stick", S::stick}, {"preload", S::preload}};
  }



  Choices<ContactParameters::FrictionDirection>
  choices(const ContactParameters::FrictionDirection)
  {
    using D = ContactParameters::FrictionDirection;
    return {{"fixed y", D::fixed_y}, {"slip", D::slip}, {"given", D::given}};
  }



  Choices<DampingParameters::Model>
  choices(const DampingParameters::Model)
  {
    using M = DampingParameters::Model;
    return {{"none", M::none},
            {"whole model", M::whole_model},
            {"per part", M::per_part}};
  }



  Choices<MatrixPartParameters::Role>
  choices(const MatrixPartParameters::Role)
  {
    using R = MatrixPartParameters::Role;
    return {{"mass", R::mass},
            {"damping", R::damping},
            {"stiffness", R::stiffness},
            {"normal contact", R::normal_contact},
            {"friction", R::friction},
            {"circulatory", R::circulatory}};
  }



  Choices<MatrixPartParameters::Format>
  choices(const MatrixPartParameters::Format)
  {
    using F = MatrixPartParameters::Format;
    return {{"automatic", F::automatic},
            {"MatrixMarket", F::matrix_market},
            {"Abaqus", F::abaqus},
            {"Nastran", F::nastran}};
  }



  Choices<DiscretizationParameters::Refinement>
  choices(const DiscretizationParameters::Refinement)
  {
    using R = DiscretizationParameters::Refinement;
    return {{"none", R::none},
            {"uniform", R::uniform},
            {"eigenvalue error", R::eigenvalue_error},
            {"contact error", R::contact_error}};
  }



  Choices<EigenParameters::Solver>
  choices(const EigenParameters::Solver)
  {
    using S = EigenParameters::Solver;
    return {{"certified", S::certified}, {"direct", S::direct}};
  }



  Choices<EigenParameters::LinearSolver>
  choices(const EigenParameters::LinearSolver)
  {
    using L = EigenParameters::LinearSolver;
    return {{"automatic", L::automatic},
            {"direct", L::direct},
            {"out of core", L::out_of_core}};
  }



  Choices<SweepAxisParameters::Scale>
  choices(const SweepAxisParameters::Scale)
  {
    using S = SweepAxisParameters::Scale;
    return {{"logarithmic", S::logarithmic},
            {"linear", S::linear},
            {"list", S::list}};
  }



  Choices<SweepAxisParameters::Distribution>
  choices(const SweepAxisParameters::Distribution)
  {
    using D = SweepAxisParameters::Distribution;
    return {{"uniform", D::uniform}, {"normal", D::normal}};
  }



  Choices<SweepAxisParameters::ShownAs>
  choices(const SweepAxisParameters::ShownAs)
  {
    using S = SweepAxisParameters::ShownAs;
    return {{"value", S::value},
            {"common logarithm", S::common_logarithm},
            {"milli", S::milli},
            {"kilo", S::kilo},
            {"mega", S::mega},
            {"giga", S::giga}};
  }



  Choices<WorkPrecisionParameters::Ladder>
  choices(const WorkPrecisionParameters::Ladder)
  {
    using L = WorkPrecisionParameters::Ladder;
    return {{"degree", L::degree},
            {"refinement", L::refinement},
            {"cells", L::cells},
            {"adaptive", L::adaptive},
            {"basis", L::basis},
            {"cut-off", L::cut_off},
            {"time step", L::time_step}};
  }



  Choices<WorkPrecisionParameters::Problem>
  choices(const WorkPrecisionParameters::Problem)
  {
    using P = WorkPrecisionParameters::Problem;
    return {{"eigenvalues", P::eigenvalues},
            {"steady sliding", P::steady_sliding},
            {"transient", P::transient}};
  }



  Choices<TransientParameters::Start>
  choices(const TransientParameters::Start)
  {
    using S = TransientParameters::Start;
    return {{"steady sliding", S::steady_sliding}, {"ramp", S::ramp}};
  }



  Choices<TransientParameters::Integrator>
  choices(const TransientParameters::Integrator)
  {
    using I = TransientParameters::Integrator;
    return {{"reduced", I::reduced},
            {"implicit", I::implicit},
            {"explicit", I::explicit_}};
  }



  Choices<TransientParameters::ContactMethod>
  choices(const TransientParameters::ContactMethod)
  {
    using M = TransientParameters::ContactMethod;
    return {{"newton", M::newton}, {"gauss-seidel", M::gauss_seidel}};
  }



  Choices<TransientParameters::DiscFrame>
  choices(const TransientParameters::DiscFrame)
  {
    using F = TransientParameters::DiscFrame;
    return {{"eulerian", F::eulerian}, {"corotating", F::corotating}};
  }



  Choices<DiscretizationParameters::Mass>
  choices(const DiscretizationParameters::Mass)
  {
    using M = DiscretizationParameters::Mass;
    return {{"consistent", M::consistent}, {"lumped", M::lumped}};
  }



  Choices<FrequencyResponseParameters::Quantity>
  choices(const FrequencyResponseParameters::Quantity)
  {
    using Q = FrequencyResponseParameters::Quantity;
    return {{"receptance", Q::receptance},
            {"mobility", Q::mobility},
            {"accelerance", Q::accelerance}};
  }



  Choices<FrequencyResponseParameters::Residual>
  choices(const FrequencyResponseParameters::Residual)
  {
    using R = FrequencyResponseParameters::Residual;
    return {{"none", R::none},
            {"flexibility", R::flexibility},
            {"flexibility and inertia", R::flexibility_and_inertia}};
  }



  Choices<FrequencyResponseParameters::Scale>
  choices(const FrequencyResponseParameters::Scale)
  {
    using S = FrequencyResponseParameters::Scale;
    return {{"linear", S::linear}, {"logarithmic", S::logarithmic}};
  }



  Choices<UpdatingParameters::Pairing>
  choices(const UpdatingParameters::Pairing)
  {
    using P = UpdatingParameters::Pairing;
    return {{"name", P::name}, {"shape", P::shape}};
  }



  Choices<OutputParameters::Shapes>
  choices(const OutputParameters::Shapes)
  {
    using S = OutputParameters::Shapes;
    return {{"none", S::none}, {"unstable", S::unstable}, {"all", S::all}};
  }
} // namespace squeal
