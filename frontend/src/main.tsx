import { QueryClientProvider } from "@tanstack/react-query";
import { StrictMode } from "react";
import { createRoot } from "react-dom/client";

import { connectLive } from "./api/live";
import { families, materials, presets, queryClient } from "./api/queries";
import { Studio } from "./app/Studio";
import { announceJobs } from "./jobs/announce";
import { followForLadder } from "./ladder/ask";
import { followForEffects } from "./scene/effectPlan";
import { followBench } from "./workbench/answers";
import { followForRefined } from "./workbench/refined";
import "./theme/tokens.css";
import "./theme/base.css";
import "./theme/theme";
import "./styles/index.css";

const root = document.getElementById("root");
if (!root) throw new Error("The page has no root element.");

// The panels ask for these too and show what fails; here they only start early.
const early = [queryClient.query(families), queryClient.query(presets), queryClient.query(materials)];
void Promise.allSettled(early);

connectLive();
followBench();
followForRefined();
followForEffects();
followForLadder();
announceJobs();

createRoot(root).render(
  <StrictMode>
    <QueryClientProvider client={queryClient}>
      <Studio />
    </QueryClientProvider>
  </StrictMode>,
);
