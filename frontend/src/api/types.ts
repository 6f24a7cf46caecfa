/** Short names for what the generated schema describes; nothing here is declared by hand. */
import type { components } from "./schema";

type Schemas = components["schemas"];

export type Family = Schemas["FamilyInfo"];
export type Parameter = Schemas["ParameterInfo"];
export type Preset = Schemas["PresetInfo"];
export type Material = Schemas["MaterialInfo"];
export type DesignCheck = Schemas["DesignCheck"];
export type Drawing = Schemas["Drawing"];
export type DrawingView = Schemas["DrawingView"];
export type DimensionLine = Schemas["DimensionLine"];
export type Prediction = Schemas["Prediction"];
export type LeftOut = Schemas["LeftOutLoad"];
export type Result = Schemas["ResultDocument"];
export type PathPoint = Schemas["PathPoint"];
export type FileKind = Schemas["FileInfo"]["what"];
export type Job = Schemas["Job"];
export type DesignSummary = Schemas["DesignSummary"];
export type DesignDetail = Schemas["DesignDetail"];
export type VersionDetail = Schemas["VersionDetail"];
export type VersionSummary = Schemas["VersionSummary"];
export type ResultSummary = Schemas["ResultSummary"];
export type Comparison = Schemas["Comparison"];
export type ComparedSide = Schemas["ComparedSide"];
export type LiveEvent = Schemas["LiveEvent"];
export type ContentRequest = Schemas["ContentRequest"];
export type ProblemDetail = Schemas["ProblemDetail"];
export type ProposedChange = Schemas["ProposedChange"];
export type Ladder = Schemas["LadderAnswer"];
export type LadderPoint = Schemas["LadderPoint"];
export type EffectPlan = Schemas["EffectDecisions"];
export type EffectDecision = Schemas["EffectDecision"];
export type Health = Schemas["Health"];
