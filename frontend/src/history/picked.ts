/** A version ticked for comparison. */
export interface Picked {
  readonly id: string;
  readonly title: string;
}
