// The worker of the formula's page.

import { serveJobs } from "../common/serve.js";
import { FormulaPipeline } from "./pipeline.js";

serveJobs(new FormulaPipeline());
