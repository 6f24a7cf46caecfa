/** Questions of which only the latest matters: at most one is on its way, and while it is, later
 * ones replace each other. */
export class Lane<Question, Answer> {
  private waiting: { question: Question } | null = null;
  private busy = false;

  constructor(
    private readonly send: (question: Question) => Promise<Answer>,
    private readonly onAnswer: (question: Question, answer: Answer) => void,
    private readonly onError: (question: Question, error: unknown) => void,
  ) {}

  ask(question: Question): void {
    this.waiting = { question };
    if (!this.busy) void this.drain();
  }

  /** True while the answer shown is not the answer to the latest question. */
  get pending(): boolean {
    return this.busy || this.waiting !== null;
  }

  private async drain(): Promise<void> {
    this.busy = true;
    while (this.waiting) {
      const { question } = this.waiting;
      this.waiting = null;
      try {
        const answer = await this.send(question);
        this.onAnswer(question, answer);
      } catch (error) {
        this.onError(question, error);
      }
    }
    this.busy = false;
  }
}
