/** Accuracy that the next finite-element job is asked for, which also decides its effects. */
import { Store } from "../api/store";

export const ACCURACIES = [
  { value: "0.1", label: "10 %", title: "A first look" },
  { value: "0.05", label: "5 %", title: "Meshes are refined until the estimated errors are below 5 %" },
  { value: "0.02", label: "2 %", title: "Fine meshes" },
  { value: "0.01", label: "1 %", title: "Fine meshes: takes the longest" },
] as const;

export type Accuracy = (typeof ACCURACIES)[number]["value"];

export const accuracy = new Store<Accuracy>("0.05");
