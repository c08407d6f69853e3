// The worker of the cortex's page.

import init from "../../pkg/index.js";
import { serveJobs } from "../common/serve.js";
import { CortexPipeline } from "./pipeline.js";

serveJobs(new CortexPipeline(), init);
