# One image for the team's web process and its workers; see docker-compose.yml.
FROM node:22-bookworm-slim AS page
WORKDIR /studio/frontend
COPY frontend/package.json frontend/package-lock.json ./
RUN npm ci --no-audit --no-fund
COPY openapi.json /studio/
COPY frontend ./
RUN npm run build

FROM python:3.11-slim-bookworm
RUN useradd --create-home studio && install -d -o studio /studio
USER studio
WORKDIR /studio
RUN python -m venv .venv
ENV PATH=/studio/.venv/bin:$PATH PYTHONUNBUFFERED=1
COPY --chown=studio pyproject.toml requirements.lock README.md LICENSE ./
COPY --chown=studio actuators actuators
COPY --chown=studio storage storage
COPY --chown=studio backend backend
COPY --chown=studio worker worker
# the lock constrains: what only tests need stays out
RUN pip install --no-cache-dir --constraint requirements.lock --editable .
RUN python -m actuators.mechanics.continuum.warm
COPY --chown=studio --from=page /studio/frontend/dist frontend/dist
