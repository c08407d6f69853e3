// The worker of the formula's page.

import init from "../../pkg/formula/index.js";
import { serveJobs } from "../common/serve.js";
import { FormulaPipeline } from "./pipeline.js";

serveJobs(new FormulaPipeline(), init);
